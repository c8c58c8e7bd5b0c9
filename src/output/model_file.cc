#include "upbead/output/model_file.h"

#include "hdf5_image.h"
#include "model_layout.h"
#include "model_modes.h"
#include "model_pieces.h"
#include "model_slip.h"

namespace upbead {

namespace {

using detail::Hdf5Image;

void write_loads(Hdf5Image& image, const std::vector<ModelLoad>& loads) {
  std::vector<std::string> name, unit;
  std::vector<double> peak, duration;
  for (const ModelLoad& load : loads) {
    name.push_back(load.name);
    unit.push_back(load.unit);
    peak.push_back(load.peak);
    duration.push_back(load.duration);
  }
  image.group("/loads");
  image.texts("/loads/name", name);
  image.texts("/loads/unit", unit);
  image.numbers("/loads/peak", {peak.size()}, peak.data(), {"that of the load", "largest |f_k| of the case"});
  image.numbers("/loads/duration", {duration.size()}, duration.data(),
                {"s", "shortest time in which the load rises and falls in the case"});
}

void write_validity(Hdf5Image& image, const ReducedModelFile& model) {
  image.group("/validity");
  image.attribute("/validity", "highest_frequency", model.highest_frequency);
  image.attribute("/validity", "tolerance", model.tolerance);
  image.attribute("/validity", "error", model.error);
  image.attribute("/validity", "error_peak", model.error_peak);
  if (model.error_march) image.attribute("/validity", "error_march", *model.error_march);
}

void write_origin(Hdf5Image& image, const ReducedModelFile& model) {
  image.text("/case", model.case_text);
  image.attribute("/case", "caisson_mass", model.caisson_mass);
  image.attribute("/case", "end", model.end);
  image.attribute("/case", "unknowns", model.unknowns);
  image.attribute("/case", "solves", model.solves);
  image.attribute("/case", "factorisations", model.factorisations);
}

void write_sliding(Hdf5Image& image, const ModelSliding& sliding) {
  image.group("/sliding");
  image.attribute("/sliding", "friction", sliding.friction);
  image.attribute("/sliding", "buoyant_weight", sliding.buoyant_weight);
  image.attribute("/sliding", "drag", sliding.drag);
  image.attribute("/sliding", "uplift", sliding.uplift);
  image.attribute("/sliding", "uplift_per_force", sliding.uplift_per_force);
  image.attribute("/sliding", "lag", sliding.lag);
}

}  // namespace

std::string model_file(const ReducedModelFile& model) {
  Hdf5Image image(model.title);
  image.attribute("/", "kind", std::string(detail::model_layout::kind));
  image.attribute("/", "format_version", detail::model_layout::version);
  write_origin(image, model);
  write_loads(image, model.loads);
  detail::write_labels(image, "/readings", model.modes.reading_label);
  detail::write_modes(image, "/modes", model.modes);
  write_validity(image, model);
  if (model.nested) detail::write_nested(image, *model.nested);
  if (model.sliding) write_sliding(image, *model.sliding);
  if (model.slip) detail::write_slip(image, *model.slip);
  image.seal();
  return image.bytes();
}

}  // namespace upbead
