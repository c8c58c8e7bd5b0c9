#include "run/safety.h"

#include "base/progress.h"
#include "base/text.h"
#include "fem/rest_state.h"

namespace upbead {

namespace {

bool lacks_rest(const Summary& summary) {
  return summary.nonlinear && !summary.nonlinear->why_no_rest.empty();
}

/// Why the ground cannot be at rest; "" where it can, or where that is not known.
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

Check rest_check(const Scene& scene, const Summary& summary) {
  Check check;
  check.name = "strength at rest";
  check.capacity = scene.limits.safety.value_or(1.);
  check.measure = summary.safety ? "safety.lower" : "nonlinear.rest";
  check.assumption = "factor by which the strength may fall under the weights alone (Griffiths and Lane 1999)";
  const bool falls = !why_not_at_rest(summary).empty();
  if (summary.safety && (summary.safety->lower || falls)) {
    check.demand = summary.safety->lower ? summary.safety->lower : summary.safety->upper;
    if (!summary.safety->why_open.empty()) check.assumption += "; " + summary.safety->why_open;
  } else if (!falls && !lacks_rest(summary) && !summary.safety) {
    check.demand = 1.;
    check.assumption += "; at least 1, as a state at rest was found: initial.safety = true finds how much more";
  } else {
    check.assumption += summary.safety ? "; not found: " + summary.safety->why_open : "";
    return check;
  }
  if (check.demand) check.margin = *check.demand / *check.capacity;
  check.holds = check.demand && *check.demand >= *check.capacity;
  return check;
}

constexpr const char* cure =
    ": nothing that was computed from there is of a section that stands; check the strengths (c' in Pa, phi' in "
    "degrees), the water level and the slopes";

}  // namespace

std::optional<SafetySummary> find_safety(const Simulation& simulation, const Summary& so_far) {
  const Scene& given = simulation.given;
  if (!(given.initial && given.initial->safety) && !given.limits.safety && !lacks_rest(so_far)) return std::nullopt;
  const SafetyFactor found =
      safety_factor(simulation.scene, *simulation.mesh, simulation.soil_state, watched("strength reduction"));
  return SafetySummary{found.lower, found.upper, found.fails_at, found.why};
}

void judge_rest(const Scene& scene, Summary& summary) {
  if (!summary.safety && !(summary.nonlinear && (summary.nonlinear->rest || lacks_rest(summary)))) return;
  summary.why_void = why_not_at_rest(summary);
  const auto& safety = summary.safety;
  const bool open = safety && summary.why_void.empty() && !(safety->lower && *safety->lower >= 1.);
  for (Check& check : summary.checks) {
    if (summary.why_void.empty()) break;
    check.margin.reset();
    check.holds.reset();
    check.assumption = "void: " + summary.why_void + (check.assumption.empty() ? "" : "; " + check.assumption);
  }
  if (summary.sliding && !summary.why_void.empty())
    summary.sliding->design.why = "void: " + summary.why_void + "; " + summary.sliding->design.why;
  const Check check = rest_check(scene, summary);
  summary.checks.insert(summary.checks.begin(), check);
  const double factor = safety ? safety->upper.value_or(safety->lower.value_or(0.)) : 0.;
  if (!summary.why_void.empty())
    summary.warnings.push_back({"no_rest", factor, 1., "1", summary.why_void + cure});
  else if (open)
    summary.warnings.push_back({"rest_open", factor, 1., "1",
                                "whether the ground stands under its own weight is not known: " + safety->why_open +
                                    "; try mesh.refine = 1, or another size of cells"});
}

}  // namespace upbead
