#include "cli/respond_input.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "model/quantities.h"
#include "sliding/still_water_push.h"

namespace upbead {

namespace {

void require_positive(const std::optional<double>& value, const std::string& option, const std::string& example,
                      Diagnostics& mistakes) {
  if (value && !(*value > 0. && std::isfinite(*value)))
    mistakes.add(Place(), option + " " + significant(*value) + " is not above 0",
                 "give a positive number such as " + example);
}

/// Mistakes of --soil and --histories that are seen before the model is read.
void check_soil_options(const RespondArguments& arguments, Diagnostics& mistakes) {
  if (is_case(arguments.model) && !arguments.soil.empty())
    mistakes.add({"--soil"}, "a case is the model of its own soil", "give a model of soils, or change the case's keys");
  if (arguments.serves() && arguments.soil.size() > 1)
    mistakes.add({"--soil -"}, "soils come from standard input, where each has all that it changes",
                 "leave out the other --soil");
  if (arguments.serves() && !arguments.out.empty())
    mistakes.add({"--out"}, "answers to soils from standard input are printed, and no file is written",
                 "leave out --out");
  if (!arguments.serves() && !arguments.histories.empty())
    mistakes.add({"--histories"}, "histories by name are printed for soils from standard input only",
                 "give --soil -, too, or take those of responses.h5");
}

/// SI units of the loads, in the model's order; "" where the file gives none for a load.
std::vector<std::string> units_of_loads(const ReducedModelFile& model) {
  std::vector<std::string> units;
  for (const std::string& name : model.modes.load_name) {
    const auto load = std::find_if(model.loads.begin(), model.loads.end(),
                                   [&name](const ModelLoad& one) { return one.name == name; });
    units.push_back(load == model.loads.end() ? "" : load->unit);
  }
  return units;
}

}  // namespace

bool RespondArguments::serves() const {
  return std::find(soil.begin(), soil.end(), "-") != soil.end();
}

void check(const RespondArguments& arguments) {
  Diagnostics mistakes;
  require_positive(arguments.end, "--end", "2 (s)", mistakes);
  require_positive(arguments.friction, "--friction", "0.6", mistakes);
  require_positive(arguments.submerged_weight, "--buoyant-weight", "3.4e6 (N/m)", mistakes);
  if (arguments.forces.empty() && !is_case(arguments.model))
    mistakes.add(Place(), "there is no wave to answer", "give files of waves after the model, such as storm.csv");
  check_soil_options(arguments, mistakes);
  mistakes.throw_if_any();
}

std::optional<ModelSliding> sliding_of(const RespondArguments& arguments, const ReducedModelFile& model) {
  const bool asked = arguments.friction || arguments.submerged_weight;
  if (!asked && !model.sliding) return std::nullopt;
  ModelSliding sliding = model.sliding.value_or(ModelSliding());
  if (sliding.uplift == "history") {
    if (!asked) return std::nullopt;  // that record belongs to one wave only
    sliding.uplift = "none";
  }
  sliding.friction = arguments.friction.value_or(sliding.friction);
  const StillWater still = model.still.value_or(StillWater());
  if (arguments.submerged_weight) sliding.submerged_weight = *arguments.submerged_weight + still.weight;
  sliding.push = still.push;
  Diagnostics mistakes;
  const std::string moved = moved_by_still_water({still.push, 0., 0.}, sliding.friction, sliding.submerged_weight);
  if (model.still && sliding.friction > 0. && sliding.submerged_weight > 0. && !moved.empty())
    mistakes.add(Place(), moved, "give a larger --friction or --buoyant-weight");
  if (sliding.friction == 0.)
    mistakes.add(Place(), "--buoyant-weight alone gives no resistance mu W', and the model's case has no [sliding]",
                 "give --friction too, such as 0.6");
  if (sliding.submerged_weight == 0.)
    mistakes.add(Place(), "--friction alone gives no resistance mu W', and the model's case has no [sliding]",
                 "give --buoyant-weight too (N/m)");
  if (model.caisson_mass == 0.)
    mistakes.add({arguments.model}, "the model has no mass of a caisson, so nothing can slide",
                 "leave out --friction and --buoyant-weight, or reduce a case with a caisson");
  mistakes.throw_if_any();
  return sliding;
}

NumberedWarnings warnings_of_options(const RespondArguments& arguments, const ReducedModelFile& model) {
  constexpr double g = 9.81;
  // scaled cases may have more gravity: then their own W' is above that
  const double weight = std::max(model.caisson_mass * g, model.base ? model.base->weight : 0.);
  const Quantity of_weight{"1", 0.02, 1., 0.2, 1., {{"kN/m", 1e3}, {"MN/m", 1e6}, {"t/m", 1e3 * g}, {"kg/m", g}}};
  NumberedWarnings list;
  judge("--friction", arguments.friction, quantities::friction, list);
  judge("--buoyant-weight", arguments.submerged_weight,
        of(of_weight, weight, "N/m", "W' is less than the weight in air, its upper bound here"), list);
  constexpr double unsafe = 0.02, mistaken = 0.1;  // as submerged_weight of a run
  const double own = model.sliding ? model.sliding->submerged_weight : model.base ? model.base->weight : infinity;
  const double excess = arguments.submerged_weight.value_or(0.) / own - 1.;
  if (excess > unsafe && list.empty())
    list.push_back({"submerged_weight", *arguments.submerged_weight, own, "N/m",
                    "--buoyant-weight " + with_unit(*arguments.submerged_weight, "N/m") + " is " +
                        significant(100. * excess, 2) + " % above " + with_unit(own, "N/m") + " of the model's case",
                    "give W' in still water, W less the weight of the displaced water", excess > mistaken});
  return list;
}

std::vector<WaveFile> waves_of(const RespondArguments& arguments, const RespondCases& cases,
                               const ReducedModelFile& model) {
  std::vector<std::string> files, of_cases;
  for (const std::string& path : arguments.forces) (is_case(path) ? of_cases : files).push_back(path);
  if (arguments.forces.empty()) of_cases.push_back(arguments.model);
  std::vector<WaveFile> waves;
  if (!files.empty())
    waves = read_wave_files(files, model.modes.load_name, units_of_loads(model), arguments.end.value_or(model.end));
  for (const std::string& path : of_cases) {
    WaveFile wave = cases.wave(path, model);
    const auto has_name = [&wave](const WaveFile& other) { return other.name == wave.name; };
    while (std::any_of(waves.begin(), waves.end(), has_name)) wave.name += "-case";
    waves.push_back(std::move(wave));
  }
  return waves;
}

}  // namespace upbead
