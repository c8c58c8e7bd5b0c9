#include "base/text.h"
#include "model_modes.h"
#include "model_parts.h"
#include "model_pieces.h"
#include "model_slip.h"
#include "upbead/output/model_file.h"

namespace upbead {

namespace {

using detail::ModelParts;

void read_loads(ModelParts& parts, ReducedModelFile& model) {
  const std::vector<std::string> names = parts.texts("/loads/name");
  const std::size_t k = names.size();
  if (k == 0) parts.wrong("/loads/name names no load");
  const std::vector<std::string> units = parts.texts("/loads/unit", k);
  const std::vector<double> peaks = parts.numbers("/loads/peak", {k}),
                            durations = parts.numbers("/loads/duration", {k});
  for (const auto& [path, values] : {std::pair("/loads/peak", &peaks), std::pair("/loads/duration", &durations)})
    for (const double value : *values)
      if (value < 0.) parts.wrong(std::string(path) + " holds " + significant(value));
  for (std::size_t n = 0; n < k; ++n) model.loads.push_back({names[n], units[n], peaks[n], durations[n]});
  model.modes.load_name = names;
}

void read_validity(ModelParts& parts, ReducedModelFile& model) {
  model.highest_frequency = parts.number("/validity", "highest_frequency", true);
  model.tolerance = parts.number("/validity", "tolerance");
  model.error = parts.number("/validity", "error");
  model.error_peak = parts.number("/validity", "error_peak");
  model.error_march = parts.optional_number("/validity", "error_march");
}

void read_origin(ModelParts& parts, ReducedModelFile& model) {
  model.title = parts.text("/", "title");
  const std::vector<std::string> text = parts.texts("/case", 1);
  model.case_text = text.front();
  model.caisson_mass = parts.number("/case", "caisson_mass");
  model.end = parts.number("/case", "end");
  model.unknowns = parts.count("/case", "unknowns");
  model.solves = parts.count("/case", "solves");
  model.factorisations = parts.count("/case", "factorisations");
}

void read_sliding(ModelParts& parts, ReducedModelFile& model) {
  if (!parts.has("/sliding", "friction")) return;
  ModelSliding& sliding = model.sliding.emplace();
  sliding.friction = parts.number("/sliding", "friction", true);
  sliding.buoyant_weight = parts.number("/sliding", "buoyant_weight", true);
  sliding.drag = parts.number("/sliding", "drag");
  sliding.uplift = parts.text("/sliding", "uplift");
  sliding.uplift_per_force = parts.number("/sliding", "uplift_per_force");
  sliding.lag = parts.number("/sliding", "lag");
}

}  // namespace

ReducedModelFile read_model_file(const std::string& path) {
  ModelParts parts(path);
  ReducedModelFile model;
  read_origin(parts, model);
  read_loads(parts, model);
  model.modes.reading_label = detail::read_labels(parts, "/readings");
  detail::read_modes(parts, "/modes", model.modes);
  model.nested = detail::read_nested(parts, model.modes);
  read_validity(parts, model);
  read_sliding(parts, model);
  model.slip = detail::read_slip(parts);
  parts.require_checksum();
  parts.throw_if_any();
  return model;
}

}  // namespace upbead
