// Whether the ground stands at rest, by which factor its strength may fall, and what follows for all other results.
#include "base/progress.h"
#include "base/text.h"
#include "fem/rest_state.h"
#include "findings/topics.h"
#include "output/limits.h"

namespace upbead {

namespace {

bool lacks_rest(const Summary& summary) {
  return summary.nonlinear && !summary.nonlinear->why_no_rest.empty();
}

/// `why_no_rest`: of soil that yields.
std::string why_not_at_rest(const std::optional<SafetySummary>& safety, const std::string& why_no_rest) {
  if (safety && safety->upper && *safety->upper <= 1.)
    return "the ground does not stand under its own weight: " +
           (safety->lower ? "only with its strength over " + significant(*safety->lower, 4) + ", that is times " +
                                significant(1. / *safety->lower, 3)
                          : std::string("not even with 16 times its strength")) +
           "; it gives way in " + safety->fails_at;
  return why_no_rest;
}

Checks rest_checks(const Scene& scene, const Summary& summary) {
  const bool lacks = lacks_rest(summary), falls = !summary.why_void.empty();
  if (!summary.safety && !lacks && !(summary.nonlinear && summary.nonlinear->rest)) return {};
  std::optional<double> factor;
  std::string how =
      "factor by which the strength may fall under the weights alone (Griffiths and Lane 1999); of this mesh: coarse "
      "cells give too large ones";
  if (summary.safety) {
    if (summary.safety->lower || falls) factor = summary.safety->lower ? summary.safety->lower : summary.safety->upper;
    if (!summary.safety->why_open.empty()) how += "; " + summary.safety->why_open;
  } else if (!lacks) {
    factor = 1.;
    how += "; at least 1, as a state at rest was found: initial.safety = true finds how much more";
  }
  Check check = check_of(FailureMode::strength, "strength at rest", "", factor,
                         summary.safety ? "safety.lower" : "nonlinear.rest", how);
  check.by = "statics";
  return {held_to(check, scene.limits, &Limits::safety, 1.)};
}

/// Warnings no_rest, where there is no state at rest, which voids the verdict, and rest_open, where it is not known
/// whether there is one.
NumberedWarnings rest_warnings(const Evidence& e, const Summary& summary) {
  const auto& safety = summary.safety;
  const double factor = safety ? safety->upper.value_or(safety->lower.value_or(0.)) : 0.;
  if (!summary.why_void.empty())
    return {{"no_rest", factor, 1., "1",
             "the ground cannot carry the weights; all results below are void: " + summary.why_void,
             "check the strengths (c' in Pa, phi' in degrees), the water level and the slopes", true}};
  if (!safety) return {};
  if (safety->lower && *safety->lower >= 1.)
    return reduction_warnings(e.simulation, "limits.safety", safety->lower, e.scene.limits.safety);
  return {{"rest_open", factor, 1., "1",
           "whether the ground stands under its own weight is not known: " + safety->why_open,
           "try mesh.refine = 1, or another size of cells"}};
}

OutputSchema<SafetySummary> safety_outputs() {
  using S = SafetySummary;
  return OutputSchema<S>()
      .key("lower", &S::lower, "",
           "largest factor at which a state at rest was found; null where none was with up to 16 times its strength")
      .key("upper", &S::upper, "",
           "smallest factor at which it was shown that there is none; null where it stands with a twentieth of its "
           "strength, "
           "or nothing was shown")
      .key("fails_at", &S::fails_at, "", "where it shears most as it fails; empty where it does not")
      .reason("why_open", &S::why_open,
              "why the bounds are more than 0.5 % apart, or missing; null where they are not");
}

}  // namespace

std::optional<SafetySummary> find_safety(const Solution& solution) {
  const Simulation& simulation = *solution.simulation;
  const Scene& scene = simulation.scene();
  const bool lacks_rest = solution.yielding && !solution.yielding->found.why_no_rest.empty();
  if (!(scene.initial && scene.initial->safety) && !scene.limits.safety && !lacks_rest) return std::nullopt;
  const SafetyFactor found =
      safety_factor(scene, *simulation.mesh(), simulation.soil_state(), shown_progress("strength reduction"));
  return SafetySummary{found.lower, found.upper, found.fails_at, found.why};
}

std::string find_why_void(const Evidence& e) {
  const auto& yielding = e.solution.yielding;
  return why_not_at_rest(e.of(find_safety), yielding ? yielding->found.why_no_rest : "");
}

Finding rest_finding() {
  Finding f;
  f.keys
      .object("safety", &Summary::safety, safety_outputs(),
              "factor by which [strength may fall at rest](yielding.md#strength-reduction), if asked for by "
              "`initial.safety` or "
              "`limits.safety`, and where Mohr-Coulomb soil found no rest; else null")
      .reason("void", &Summary::why_void,
              "why nothing here that was marched is of a section that stands: its ground [has no state at "
              "rest](yielding.md#ground-that-does-not-stand); null where it has");
  f.warnings = rest_warnings;
  f.checks = rest_checks;
  f.needs_no_march = true;
  return f.part(&Summary::safety, find_safety).part(&Summary::why_void, find_why_void);
}

}  // namespace upbead
