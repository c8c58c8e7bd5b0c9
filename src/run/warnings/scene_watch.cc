#include "scene_watch.h"

#include <cmath>

#include "../sliding/read_sliding.h"
#include "base/text.h"
#include "lift_warning.h"
#include "response/reduction.h"
#include "response/step_choice.h"
#include "scene_warnings.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

const char* const no_level = "no still water level is known: give [initial] water_level";
const char* const several = "several processes share the work";
/// Of the area, that must come to yield besides what does at rest.
constexpr double least_yielding = 0.005;

std::string place_text(const dealii::Point<dim>& at) {
  return "(" + significant(at[0]) + ", " + significant(at[1]) + ") m";
}

}  // namespace

SceneWatch::SceneWatch(const Simulation& simulation) {
  const double level = water_level(simulation.scene, *simulation.mesh);
  if (simulation.processes) {
    why_no_pressure_ = why_no_strength_ = several;
    return;
  }
  if (!std::isfinite(level)) {
    why_no_pressure_ = why_no_strength_ = no_level;
    return;
  }
  pressure_.emplace(*simulation.space, *simulation.unknowns, simulation.scene, level);
  if (!has_strength(simulation.scene)) return;
  try {
    const StaticStage rest = solve_static(simulation.scene, *simulation.mesh);
    strength_.emplace(*simulation.space, *simulation.unknowns, rest.stress, k0_of(simulation.scene));
  } catch (const NumericsError& error) {
    why_no_strength_ = error.what();
  }
}

std::vector<MarchObserver*> SceneWatch::observers() {
  std::vector<MarchObserver*> list;
  if (pressure_) list.push_back(&*pressure_);
  if (strength_) list.push_back(&*strength_);
  return list;
}

void SceneWatch::tell(Run& run) {
  const Simulation& simulation = *run.simulation;
  std::optional<double> peak_time;
  if (run.summary.response) peak_time = run.summary.response->peak_shear_time;
  run.summary.warnings = warnings(simulation, peak_time);
  tell_pressure(simulation, run);
  tell_strength(run);
  for (NumberedWarning& warning : lift_warnings(simulation, run)) run.summary.warnings.push_back(std::move(warning));
  if (run.summary.sliding)
    for (NumberedWarning& warning : slip_warnings(*run.summary.sliding))
      run.summary.warnings.push_back(std::move(warning));
}

void SceneWatch::tell_pressure(const Simulation& simulation, Run& run) {
  if (run.pressures && pressure_)
    pressure_->see(*run.pressures, sampled_loads(simulation.scene, simulation.compiled->system),
                   step_of_loads(simulation.scene, 4).duration);
  if (pressure_ && !pressure_->watches()) return;
  if (!pressure_ || !pressure_->has_seen()) {
    if (simulation.compiled->caisson)
      run.summary.skipped.push_back(
          {"cavitation of the water", pressure_ ? "the contact was not marched" : why_no_pressure_});
    return;
  }
  if (pressure_->value() >= vapour_pressure) return;
  run.summary.warnings.push_back(
      {"cavitation", pressure_->value(), vapour_pressure, "Pa",
       "the water of '" + pressure_->region() + "' at " + place_text(pressure_->place()) + " would come to " +
           significant(pressure_->value() / 1e3) + " kPa absolute at " + significant(pressure_->time()) +
           " s, below its vapour pressure of 2.3 kPa: it would boil or draw air, which is not modelled; what comes "
           "after is not to be trusted, compare with fluid.bulk_modulus = 1e7 (air in the water)"});
}

void SceneWatch::tell_strength(Run& run) const {
  if (strength_ && strength_->has_seen())
    run.summary.strength = strength_->found();
  else if (!why_no_strength_.empty() || strength_)
    run.summary.skipped.push_back({"mobilised strength", strength_ ? "the contact was not marched" : why_no_strength_});
  for (const MobilisedStrength& s : run.summary.strength)
    if (s.share > s.initial_share + least_yielding)
      run.summary.warnings.push_back({"strength", s.largest, 1., "1",
                                      "in " + significant(100. * s.share, 2) + " % of region '" + s.region + "' (" +
                                          significant(100. * s.initial_share, 2) +
                                          " % at rest) the stresses exceed the soil's strength, at most " +
                                          (s.largest < 10. ? "" : "more than ") + significant(s.largest) +
                                          " times at " + place_text({s.at[0], s.at[1]}) + " at " + significant(s.time) +
                                          " s: it would yield, which linear soil does not; use [regions." + s.region +
                                          ".strain], smaller loads, or a stronger soil"});
}

}  // namespace upbead
