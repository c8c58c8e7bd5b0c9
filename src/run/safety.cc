#include "run/safety.h"

#include "base/progress.h"
#include "base/text.h"
#include "fem/rest_state.h"
#include "output/checks.h"

namespace upbead {

namespace {

bool lacks_rest(const Summary& summary) {
  return summary.nonlinear && !summary.nonlinear->why_no_rest.empty();
}

constexpr const char* cure =
    ": nothing that was computed from there is of a section that stands; check the strengths (c' in Pa, phi' in "
    "degrees), the water level and the slopes";

}  // namespace

std::string why_not_at_rest(const Summary& summary) {
  const auto& safety = summary.safety;
  if (safety && safety->upper && *safety->upper <= 1.)
    return "the ground does not stand under its own weight: " +
           (safety->lower ? "only with its strength over " + significant(*safety->lower, 4) + ", that is times " +
                                significant(1. / *safety->lower, 3)
                          : std::string("not even with 16 times its strength")) +
           "; it gives way in " + safety->fails_at;
  return lacks_rest(summary) ? summary.nonlinear->why_no_rest : "";
}

std::optional<SafetySummary> find_safety(const Simulation& simulation, const Summary& so_far) {
  const Scene& given = simulation.given;
  if (!(given.initial && given.initial->safety) && !given.limits.safety && !lacks_rest(so_far)) return std::nullopt;
  const SafetyFactor found =
      safety_factor(simulation.scene, *simulation.mesh, simulation.soil_state, watched("strength reduction"));
  return SafetySummary{found.lower, found.upper, found.fails_at, found.why};
}

Checks rest_checks(const Scene& scene, const Summary& summary) {
  const bool lacks = lacks_rest(summary), falls = !why_not_at_rest(summary).empty();
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
  Check check = check_of("strength at rest", "", factor, summary.safety ? "safety.lower" : "nonlinear.rest", how);
  check.by = "statics";
  return {at_least_as(check, scene.limits.safety.value_or(1.))};
}

NumberedWarnings rest_warnings(const Summary& summary) {
  const auto& safety = summary.safety;
  const double factor = safety ? safety->upper.value_or(safety->lower.value_or(0.)) : 0.;
  if (!summary.why_void.empty()) return {{"no_rest", factor, 1., "1", summary.why_void + cure, true}};
  if (!safety || (safety->lower && *safety->lower >= 1.)) return {};
  return {{"rest_open", factor, 1., "1",
           "whether the ground stands under its own weight is not known: " + safety->why_open +
               "; try mesh.refine = 1, or another size of cells"}};
}

}  // namespace upbead
