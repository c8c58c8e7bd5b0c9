#include "run/monitors.h"

#include <cmath>

#include "base/text.h"
#include "fem/compile.h"
#include "response/compaction.h"
#include "response/reduction.h"
#include "response/time_choice.h"
#include "run/checks.h"
#include "run/contact/contact_run.h"
#include "run/safety.h"
#include "run/sliding/coupled_sliding.h"
#include "run/sliding/effective_base.h"
#include "run/solve.h"
#include "run/warnings/yielding_warnings.h"
#include "upbead/base/error.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// A rigid bottom on elastic ground has more stress at its edges than a linear distribution: it opens at 1.26 times
/// the moment at which the linear stress of an edge becomes tension, docs/slip.md.
constexpr double edge_factor = 1.26;

/// The least stress of an edge.
struct EdgeStress {
  double stress = 0.;  ///< Pa, compression positive
  double force = 0., moment = 0., time = 0.;
};

EdgeStress least_edge_stress(const EffectiveBase& base, const std::vector<double>& time) {
  EdgeStress least{1e300};
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double B = base.width, force = base.force[i], moment = base.moment[i];
    const double stress = force / B - 6. * std::abs(moment) / (edge_factor * B * B);
    if (stress < least.stress) least = {stress, force, moment, time[i]};
  }
  return least;
}

/// Warning would_lift: an edge of a bonded caisson is in tension, by its effective stress N'/B - 6 |M'|/(1.26 B^2).
/// N' = W' + change of the normal force - U, M' = W' e + base moment + moment of U, where U is that of the modelled
/// pore pressure and e is how far W' acts landward of the bottom's middle. W' is that of [sliding] minus a prescribed
/// uplift, or the mass minus the water that the caisson displaces below still water; without either there is no
/// warning.
NumberedWarnings lift_warnings(const std::optional<EffectiveBase>& base, const Run& run) {
  if (run.summary.contact || !base) return {};
  const EdgeStress least = least_edge_stress(*base, run.response.ends.time);
  if (least.stress >= 0.) return {};
  const std::string which = least.force < 0.    ? "the whole caisson"
                            : least.moment > 0. ? "its seaward edge"
                                                : "its landward edge";
  return {
      {"would_lift", least.stress, 0., "Pa",
       which + " would pull at the ground with " + with_unit(-least.stress, "Pa") + " at " + significant(least.time) +
           " s (N' = " + with_unit(least.force, "N/m") + ", moment " + with_unit(least.moment, "N m/m") +
           "), a tension that a bonded base bears and a real one does not: write [regions.caisson.interface] kind = "
           "\"friction\""}};
}

/// Warning base_pressure: an edge has a larger pressure than the case allows.
NumberedWarnings pressure_warnings(const std::optional<BaseSummary>& base) {
  if (!base || !base->limit || !base->peak_heel_pressure || !base->peak_toe_pressure) return {};
  const bool heel = *base->peak_heel_pressure >= *base->peak_toe_pressure;
  const double largest = heel ? *base->peak_heel_pressure : *base->peak_toe_pressure;
  if (largest <= *base->limit) return {};
  return {{"base_pressure", largest, *base->limit, "Pa",
           std::string("the ") + (heel ? "heel" : "toe") + " presses with " + with_unit(largest, "Pa") + " at " +
               significant(heel ? base->peak_heel_pressure_time : base->peak_toe_pressure_time) +
               " s, more than limits.base_pressure: widen the caisson, or spread its weight seaward"}};
}

/// Warning no_coupled_slip: the coupled S would not be right.
NumberedWarnings slip_warnings(const SlidingSummary& sliding) {
  if (!sliding.coupled_failed) return {};
  return {{"no_coupled_slip", sliding.history.ratio, 1., "1",
           "the bonded caisson reaches its friction, but the distance that it slips as a whole on its ground could not "
           "be computed: " +
               sliding.why_not_coupled + "; sliding_history, and contact node by node (kind = \"friction\"), give S"}};
}

/// The slips that did not need to be computed, and why.
std::vector<Skipped> skipped(const SlidingSummary& sliding) {
  const std::string what = "slip of the caisson with its ground";
  if (!sliding.why_not_coupled.empty()) return {{what, sliding.why_not_coupled}};
  if (sliding.coupled && sliding.coupled->vectors == 0)
    return {{what, "|F_T| stays below mu N' at all times: the bonded caisson does not slip"}};
  return {};
}

NumberedWarnings balance_warnings(const Run& run) {
  const std::optional<Mismatch> off = imbalance(*run.simulation, run);
  if (!off) return {};
  return {
      {"balance_loose", off->value, off->tolerable, "1",
       off->what + " by " + significant(off->value) + ", where " + significant(off->tolerable) +
           " is usual: large forces cancel in this scene and leave their round-off; F_T may err by up to " +
           significant(off->error, 2) + " of its largest value, motions by that part of what the loads would do " +
           "alone; look for stiffnesses or permeabilities far from all others, or give the water its bulk modulus"}};
}

NumberedWarnings loose_warnings(const Summary& summary) {
  NumberedWarnings list;
  if (!summary.reduction || summary.reduction->loose.empty()) return list;
  std::string names;
  for (const LooseReading& reading : summary.reduction->loose) names += (names.empty() ? "" : ", ") + reading.name;
  list.push_back({"reading_not_converged", summary.reduction->error_of_others, summary.reduction->tolerance_of_others,
                  "1",
                  "the reduced model that was asked for has F_T within its tolerance, but " + names +
                      " move by up to " + significant(summary.reduction->error_of_others) +
                      " of their peaks between nested models; write time.scheme = \"sdirk4\" where they matter"});
  return list;
}

/// Share of the area that must yield in addition to what yields at rest.
constexpr double least_yielding = 0.005;

std::string place_text(const dealii::Point<dim>& at) {
  return "(" + significant(at[0]) + ", " + significant(at[1]) + ") m";
}

}  // namespace

Monitors::Monitors(const Simulation& simulation) {
  const double level = water_level(simulation.scene, *simulation.mesh);
  if (simulation.processes)
    why_no_pressure_ = why_no_strength_ = "several processes share the work";
  else if (!std::isfinite(level))
    why_no_pressure_ = why_no_strength_ = "no still water level is known: give [initial] water_level";
  if (!why_no_pressure_.empty()) return;
  pressure_.emplace(*simulation.space, *simulation.unknowns, simulation.scene, level);
  if (!has_strength(simulation.scene)) return;
  try {
    const StaticStage rest = solve_static(simulation.scene, *simulation.mesh);
    strength_.emplace(*simulation.space, *simulation.unknowns, rest.stress, k0_of(simulation.scene));
  } catch (const NumericsError& error) {
    why_no_strength_ = error.what();
  }
}

std::vector<MarchObserver*> Monitors::observers() {
  std::vector<MarchObserver*> list;
  if (pressure_) list.push_back(&*pressure_);
  if (strength_) list.push_back(&*strength_);
  return list;
}

void Monitors::report(Run& run) {
  const Simulation& simulation = *run.simulation;
  Summary& summary = run.summary;
  summary.title = simulation.given.title;
  summary.soil = simulation.soil;
  summary.loads = simulation.compiled->loads_on_caisson;
  summary.skipped = skipped(simulation, summary.reduction.has_value());
  std::optional<double> peak_time;
  if (summary.response) peak_time = summary.response->peak_shear_time;
  summary.warnings = warnings(simulation, peak_time);
  report_pressure(simulation, run);
  report_strength(simulation, run);
  const std::optional<EffectiveBase> base = effective_base(simulation, run.response.ends);
  if (base) summary.base = base_summary(simulation, *base, run.response.ends, run.contact);
  if (summary.base) summary.base->limit = simulation.given.limits.base_pressure;
  append(summary.warnings, lift_warnings(base, run));
  append(summary.warnings, pressure_warnings(summary.base));
  if (summary.sliding) append(summary.warnings, slip_warnings(*summary.sliding));
  append(summary.warnings, compaction_warnings(summary.densification));
  append(summary.warnings, loose_warnings(summary));
  append(summary.warnings, balance_warnings(run));
  append(summary.warnings, yielding_warnings(summary));
  if (summary.sliding) append(summary.skipped, skipped(*summary.sliding));
  if (summary.contact && !summary.contact->solved)
    summary.skipped.push_back({"contact node by node", why_glued(*summary.contact)});
  if (summary.sliding) summary.sliding->design = design_sliding(*summary.sliding, summary.contact, summary.residual);
  summary.checks = checks_of(simulation.given, summary);
  judge_rest(simulation.given, summary);
}

void Monitors::report_pressure(const Simulation& simulation, Run& run) {
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

void Monitors::report_strength(const Simulation& simulation, Run& run) {
  if (run.states && strength_)
    strength_->see(*run.states, sampled_loads(simulation.scene, simulation.compiled->system),
                   step_of_loads(simulation.scene, 4).duration);
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

std::vector<Skipped> skipped(const Simulation& simulation, bool reduced) {
  std::vector<Skipped> list;
  for (const Decision& decision : simulation.decisions)
    if (!decision.left_out.empty()) list.push_back({decision.left_out, decision.why});
  for (const auto& [name, load] : simulation.given.loads)
    if (load.factor == 0.) {
      list.push_back({"load " + name, "its factor is 0"});
    } else if (const auto& samples = load.history.samples(); !reduced && is_rough(load.history)) {
      list.push_back({"steps that meet the corners of load " + name,
                      "a rough record of " + std::to_string(samples.size()) +
                          " samples: F_T errs by some of its roughness (8 % for noise of 1 % measured); use "
                          "time.scheme = \"reduced\", smooth it, or give time.step = its sampling interval, " +
                          significant(samples[1] - samples[0]) + " s"});
    }
  if (!simulation.given.fields_every) list.push_back({"fields", "the case asks for none ([output] fields)"});
  if (!simulation.compiled->caisson) list.push_back({"shear force", "the mesh has no surface 'caisson'"});
  if (yields(simulation.given) && simulation.given.accuracy.estimate)
    list.push_back({"estimate of errors", "the soil yields, and errors are estimated of linear soil alone"});
  if (simulation.compiled->caisson && !has_strength(simulation.given) && !yields(simulation.given))
    list.push_back({"strength of the soil", "no region has a table strength"});
  if (!simulation.given.time.inertia) list.push_back({"inertia", "[time] inertia = false: consolidation"});
  return list;
}

}  // namespace upbead
