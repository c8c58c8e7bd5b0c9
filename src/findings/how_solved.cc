// How a scene was solved: mesh, scheme and the ways tried, what a reduced model knows of its error, times.
#include "base/text.h"
#include "fem/caisson/reading_names.h"
#include "fem/compile.h"
#include "findings/topics.h"
#include "response/natural_periods.h"
#include "response/reduction.h"
#include "run/solve.h"

namespace upbead {

namespace {

OutputSchema<Discretisation> discretisation_outputs() {
  using D = Discretisation;
  return OutputSchema<D>()
      .key("cells", &D::cells, "", "cells")
      .key("unknowns", &D::unknowns, "", "unknowns")
      .key("degree", &D::degree, "", "degree of the displacement")
      .key("scheme", &D::scheme, "", "scheme in time: `reduced`, or what marched")
      .key("time_step", &D::time_step, "s", "largest step")
      .key("steps", &D::steps, "", "steps")
      .key("solves", &D::solves, "", "solves")
      .key("factorisations", &D::factorisations, "", "factorisations")
      .key("processes", &D::processes, "", "processes: that shared the work")
      .key("why_scheme", &D::why_scheme, "", "why this scheme was taken")
      .key("why_step", &D::why_step, "", "why the steps are as long as they are")
      .key("stopped_early", &D::stopped_early, "", "whether little energy was left before the end, as the case allows");
}

OutputSchema<ReductionSummary> reduction_outputs() {
  using R = ReductionSummary;
  const auto inexact = [](const R& r) {
    Json object = Json::object();
    for (const InexactReading& reading : r.inexact) object[reading.name] = reading.error;
    return object;
  };
  return OutputSchema<R>()
      .key("vectors", &R::vectors, "", "of the Krylov space")
      .key("modes", &R::modes, "", "modes")
      .key("error", &R::error, "", "of the history of F_T, over its peak")
      .key("error_peak", &R::error_peak, "", "of its peaks")
      .key("error_of_others", &R::error_of_others, "",
           "the largest of all other readings, each over its own largest value")
      .key("error_of_states", &R::error_of_states, "",
           "of the states that fields and strengths are made of: the root of the energy of the difference, over that "
           "of the largest state; null where the case asks for neither")
      .key("error_of_soils", &R::error_of_soils, "",
           "estimated, of the histories of F_T, of the displacement and of the forces on the base over their peaks, "
           "where one model answers all soils of a study; null where this soil itself was reduced")
      .key("highest_frequency", &R::highest_frequency, "Hz", "highest frequency checked")
      .key("loose.NAME", inexact, "",
           "the readings besides F_T that have not come close enough, with their error (only where the case asks for a "
           "reduced model)");
}

OutputSchema<NaturalPeriod> period_outputs() {
  using P = NaturalPeriod;
  return OutputSchema<P>()
      .key("period", &P::period, "s", "of the free swing")
      .key("damping_ratio", &P::damping_ratio, "", "of critical")
      .key("share", &P::share, "",
           "of its largest contribution to F_T under these loads in the sum of those of all modes that swing");
}

OutputSchema<Timing> timing_outputs() {
  using T = Timing;
  return OutputSchema<T>()
      .key("mesh", &T::mesh, "s", "meshing")
      .key("compile", &T::compile, "s", "making M, C, K and loads")
      .key("factorise", &T::factorise, "s", "factorising")
      .key("march", &T::march, "s", "marching, or reducing and answering")
      .key("output", &T::output, "s", "writing")
      .key("total", &T::total, "s", "since the start of the program");
}

OutputSchema<LadderStep> ladder_outputs() {
  return OutputSchema<LadderStep>()
      .key("way", &LadderStep::way, "", "its name")
      .reason("refused", &LadderStep::refused, "why it was refused; null of the last one, which was taken");
}

/// Why the list `periods` of a caisson is empty, with a cure; "" where it is not empty, or there is no caisson.
std::string why_no_periods(const Summary& summary) {
  if (!summary.periods.empty() || !summary.response) return "";
  if (summary.reduction) return "no mode that swings has 1 % of F_T";
  return summary.why_no_periods;
}

/// Why a scene that is marched has no periods.
std::string find_why_no_periods(const Evidence& e) {
  const Scene& scene = e.scene;
  const std::string poles = "they are the poles of a reduced model, and this scene was marched; ";
  if (!scene.periods)
    return poles +
           "where one converges time.scheme = \"reduced\" tells them, or, beside a march, output.periods = true";
  if (!scene.time.inertia) return poles + "without inertia (time.inertia = false) nothing swings";
  if (has_prescribed_motion(scene)) return poles + "beside a motion that is prescribed none is made";
  if (e.simulation.processes()) return poles + "on several processes none is made: run it on one";
  return poles + "the one that output.periods asks for did not converge, or has no mode with 1 % of F_T";
}

/// The modes of a scene that was marched, of its ground as it is before anything yields; none where none converge, or
/// where several processes have its parts.
std::optional<ModalModel> modes_beside(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const CompiledScene& compiled = *simulation.compiled();
  const bool has_modes = scene.time.inertia && !has_prescribed_motion(scene) && !compiled.system.loads.empty();
  if (!has_modes || simulation.processes()) return std::nullopt;
  ReductionTargets targets;
  targets.balanced = true;
  try {
    Reduction reduction = reduce_scene(scene, compiled, targets);
    require_shear_converged(reduction);
    return std::move(reduction.model);
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

std::vector<NaturalPeriod> find_periods(const Evidence& e) {
  const Solution& bonded = bonded_of(e);
  const Simulation& simulation = *bonded.simulation;
  if (!simulation.compiled()->caisson) return {};
  const std::optional<ModalModel> beside = !bonded.model && e.scene.periods ? modes_beside(simulation) : std::nullopt;
  const ModalModel* model = beside ? &*beside : bonded.model ? &*bonded.model : nullptr;
  if (model == nullptr) return {};
  return natural_periods(*model, reading::shear_force, sampled_loads(simulation.scene(), simulation.system()));
}

std::string find_title(const Evidence& e) {
  return e.scene.title;
}

Timing find_timing(const Evidence& e) {
  Timing timing = e.solution.timing;
  if (const auto& coupled = e.of(find_slip_as_whole).coupled) timing.march += coupled->seconds;
  return timing;
}

NumberedWarnings inexact_warnings(const Evidence&, const Summary& summary) {
  NumberedWarnings list;
  if (!summary.reduction || summary.reduction->inexact.empty()) return list;
  std::string names;
  for (const InexactReading& reading : summary.reduction->inexact) names += (names.empty() ? "" : ", ") + reading.name;
  list.push_back({"reading_not_converged", summary.reduction->error_of_others, summary.reduction->tolerance_of_others,
                  "1",
                  "the reduced model that was asked for has F_T within its tolerance, but " + names + " err by up to " +
                      percent(summary.reduction->error_of_others) + " of their peaks",
                  "write time.scheme = \"sdirk4\" where these readings matter"});
  return list;
}

NumberedWarnings balance_warnings(const Evidence& e, const Summary&) {
  const std::optional<Mismatch> off = imbalance(e.simulation, e.solution);
  if (!off) return {};
  return {{"balance_loose", off->value, off->tolerable, "1",
           off->what + " by " + significant(off->value) + ", where " + significant(off->tolerable) +
               " is usual: large forces cancel in this scene and leave their round-off; F_T may err by up to " +
               significant(off->error, 2) + " of its largest value, motions by that part of what the loads would do " +
               "alone",
           "look for stiffnesses or permeabilities far from all others, or give the water its bulk modulus"}};
}

}  // namespace

Finding discretisation_finding() {
  Finding f;
  f.keys.key("title", &Summary::title, "", "that of the case")
      .program()
      .object("verdict", &Summary::verdict, verdict_outputs(), "what all checks say together; null without any")
      .object("discretisation", &Summary::discretisation, discretisation_outputs(), "how the scene was solved");
  f.warnings = balance_warnings;
  return f.part(&Summary::title, find_title).part(&Summary::discretisation, &Solution::discretisation);
}

Finding reduction_finding() {
  Finding f;
  f.keys.object("reduction", &Summary::reduction, reduction_outputs(),
                "[how far two nested models lie apart](reduced.md); null where the case was marched");
  f.warnings = inexact_warnings;
  return f.part(&Summary::reduction, &Solution::reduction);
}

Finding periods_finding() {
  Finding f;
  const auto none = [](const Summary& summary) {
    const std::string why = why_no_periods(summary);
    return why.empty() ? std::nullopt : std::make_optional(why);
  };
  f.keys
      .list(
          "periods[]", &Summary::periods, period_outputs(),
          "natural periods of ground and bonded caisson that F_T takes part in, largest share first, from 1 %; "
          "modes damped by more than 0.7 of critical do not swing; empty where no reduced model was made: a march has "
          "one with output.periods, of the ground before it yields")
      .key("no_periods", none, "", "why `periods` is empty; null where it is not, and without a caisson");
  return f.part(&Summary::periods, find_periods).part(&Summary::why_no_periods, find_why_no_periods);
}

Finding ways_finding() {
  Finding f;
  f.keys
      .list("ladder[]", &Summary::ladder, ladder_outputs(),
            "the [ways](reduced.md#the-ladder) that were tried, in their order")
      .object("timing", &Summary::timing, timing_outputs(), "wall times");
  return f.part(&Summary::ladder, &Solution::ladder).part(&Summary::timing, find_timing);
}

}  // namespace upbead
