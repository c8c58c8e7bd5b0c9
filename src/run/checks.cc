#include "run/checks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "output/checks.h"
#include "run/safety.h"
#include "upbead/model/load.h"

namespace upbead {

DesignSliding design_sliding(const SlidingSummary& s, const std::optional<ContactSummary>& contact,
                             const std::optional<ResidualSummary>& residual) {
  if (contact && contact->solved)
    return {contact->solved->slip, "contact.solved.slip", "friction is followed node by node",
            contact->solved->error_estimate};
  if (contact) return {0., "contact.solved", "no node of the bonded base reaches its friction or pulls", {}};
  if (s.coupled)
    return {s.coupled->slip.residual, "sliding.sliding_coupled",
            s.coupled->vectors > 0 ? "the caisson slips as a whole on the ground that it shakes"
                                   : "the bonded caisson does not reach mu N'",
            s.coupled->error_estimate};
  const double plain = s.history.by_history.residual, moved = s.history.with_normal_force.residual;
  const std::string why = std::string("the larger of two by F_T(t) of the bonded caisson") +
                          (residual ? ", its slip over the mound alone: how far the ground carried it stands beside it "
                                      "(residual.displacement_x)"
                                    : "") +
                          "; slip with its ground could not be computed: ";
  return std::abs(plain) >= std::abs(moved)
             ? DesignSliding{plain, "sliding.sliding_history", why + s.why_not_coupled, s.error_estimate}
             : DesignSliding{moved, "sliding.sliding_normal_force", why + s.why_not_coupled, {}};
}

namespace {

std::string about_uplift(const Scene& scene) {
  if (!scene.sliding || !scene.sliding->uplift) return "no uplift";
  const UpliftChoice& uplift = *scene.sliding->uplift;
  if (uplift.kind == UpliftKind::computed) return "uplift by the computed pore pressure";
  if (!uplift.peak) return "uplift as given over time";
  return uplift.course == UpliftCourse::held ? "uplift held at its peak" : "uplift in phase with P";
}

/// How far the caisson has moved in the end, where soil yields. Where friction was followed node by node, the
/// displacement contains the slip over the mound; else the sliding distance is added to the displacement with the
/// ground, bonded. For hysteretic soil the text gives the start with the largest displacement.
Check displacement_check(const Summary& summary, const std::optional<double>& limit) {
  const bool slipped = summary.contact && summary.contact->solved;
  const double carried = std::abs(summary.residual->displacement_x);
  const double slip = summary.sliding && !slipped ? std::abs(summary.sliding->design.value) : 0.;
  std::string how = slipped ? "slip node by node counts in it"
                            : "carried by the ground, bonded, and the sliding distance over the mound";
  const StartBound* farthest = nullptr;
  for (const StartBound& bound : summary.nonlinear->bounds)
    if (std::abs(bound.residual.displacement_x) > (farthest ? std::abs(farthest->residual.displacement_x) : carried))
      farthest = &bound;
  if (farthest)
    how += "; from the start " + farthest->start + " carried " + with_unit(farthest->residual.displacement_x, "m");
  return at_most(
      check_of("displacement with the ground", "m", carried + slip,
               slip > 0. ? "residual.displacement_x + sliding.design.value" : "residual.displacement_x", how),
      limit);
}

/// What still water at two levels adds to a force in that direction (1: landward).
double still_push(const Summary& summary, double side) {
  return summary.harbour ? side * summary.harbour->push : 0.;
}

std::string about_push(const Summary& summary) {
  return summary.harbour ? ", with the push of still water at two levels (harbour.push)" : "";
}

/// Whether a boundary's motion drives the scene: then F_T goes both ways without a trough.
bool is_shaken(const Scene& scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(),
                     [](const auto& load) { return is_motion(load.second.kind) && load.second.factor != 0.; });
}

constexpr double round_off = 1e-6;  // of the largest P

/// Where no force acts seaward, a friction that suffices for the rebound says nothing of the seaward direction.
Check seaward_check(const Scene& scene, const Summary& summary, const std::string& assumption) {
  const HistorySliding& history = summary.sliding->history;
  const Check check = at_most(
      check_of("force against friction, seaward", "N/m", std::max(history.peak_seaward + still_push(summary, -1.), 0.),
               "sliding.peak_sliding_force_seaward", assumption),
      history.resistance);
  const ShearResponse& r = *summary.response;
  const bool no_trough = r.peak_force_seaward >= -round_off * r.peak_force && !is_shaken(scene);
  if (!no_trough || !*check.holds) return check;
  return not_checked(check, "no trough acts: no load pushes the caisson seaward, and its rebound alone, " +
                                with_unit(*check.demand, "N/m") + ", stays below mu W'");
}

void add_sliding(const Scene& scene, const Summary& summary, Checks& list) {
  const SlidingSummary& sliding = *summary.sliding;
  const std::string uplift = about_uplift(scene);
  list.push_back(at_most(check_of("sliding distance", "m", std::abs(sliding.design.value), sliding.design.measure,
                                  (sliding.design.value < 0. ? "seaward; " : "") + uplift + "; " + sliding.design.why),
                         scene.limits.sliding));
  const std::string of_bonded =
      uplift + "; F_T of the bonded caisson" +
      (is_solved_with_friction(summary) ? ", before its friction was followed node by node" : "") + about_push(summary);
  list.push_back(at_most(check_of("force against friction", "N/m", sliding.history.peak_force + still_push(summary, 1.),
                                  "sliding.peak_sliding_force", of_bonded),
                         sliding.history.resistance));
  list.push_back(seaward_check(scene, summary, of_bonded));
}

/// p_e without motion, for which the limit of practice was made: by Goda's formulas of loads by waves, else of the
/// loads as they act on the caisson.
Checks bearing_checks(const Scene& scene, const BaseSummary& base) {
  Checks list;
  const auto add = [&](const std::string& edge, const std::optional<double>& pressure) {
    Check check = check_of(edge + " pressure p_e of the loads", "Pa", pressure, "base.static_" + edge + "_pressure",
                           about_uplift(scene) +
                               "; the loads without motion: Goda's p_e where the load is Goda's, more "
                               "than that where it is the peak of an impact");
    check.by = "statics";
    check = at_most(check, scene.limits.base_pressure);
    if (is_shaken(scene)) check = not_checked(check, "a motion shakes the ground, and nothing of it acts at rest");
    list.push_back(check);
  };
  add("heel", base.static_heel_pressure);
  add("toe", base.static_toe_pressure);
  return list;
}

void add_base(const Scene& scene, const Summary& summary, Checks& list) {
  const BaseSummary& base = *summary.base;
  const std::string linear = about_uplift(scene) +
                             "; of a moment in motion, effective stress linear over the width in contact: not the p_e "
                             "for which limits of bearing pressure are made";
  const auto& limit = scene.limits.dynamic_base_pressure;
  list.push_back(at_most(
      check_of("heel pressure in motion", "Pa", base.peak_heel_pressure, "base.peak_heel_pressure", linear), limit));
  list.push_back(at_most(
      check_of("toe pressure in motion", "Pa", base.peak_toe_pressure, "base.peak_toe_pressure", linear), limit));
  if (base.least_overturning_margin)
    list.push_back(at_least_as(check_of("margin against overturning", "", base.least_overturning_margin,
                                        "base.least_overturning_margin", about_uplift(scene) + "; a rigid base"),
                               scene.limits.overturning));
  if (summary.formula_checks.empty()) append(list, bearing_checks(scene, base));
}

/// A check by formulas, and that of the same question by dynamics.
struct OneQuestion {
  const char *formula, *dynamic;
};
constexpr OneQuestion same_questions[] = {{"sliding by formulas", "force against friction"},
                                          {"sliding seaward by formulas", "force against friction, seaward"},
                                          {"sliding distance by formulas", "sliding distance"},
                                          {"overturning by formulas", "margin against overturning"}};

const Check* answer_to(const std::string& name, const Checks& checks) {
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& check) { return check.name == name; });
  return found != checks.end() && found->holds ? &*found : nullptr;
}

}  // namespace

bool is_solved_with_friction(const Summary& summary) {
  return summary.contact && summary.contact->solved;
}

Checks checks_of(const Scene& scene, const Summary& summary) {
  Checks list;  // of marches from the state at rest
  if (summary.sliding && summary.response) add_sliding(scene, summary, list);
  if (summary.nonlinear && summary.residual) list.push_back(displacement_check(summary, scene.limits.sliding));
  if (summary.base) add_base(scene, summary, list);
  if (!summary.why_void.empty())
    for (Check& check : list) check = not_checked(check, "void: there is no state at rest, see no_rest");
  Checks all = rest_checks(scene, summary);
  append(all, list);
  append(all, summary.formula_checks);
  return all;
}

NumberedWarnings route_warnings(const Checks& checks) {
  NumberedWarnings list;
  for (const Check& formula : checks)
    for (const auto& [by_formula, by_dynamics] : same_questions) {
      const Check* dynamic = answer_to(by_dynamics, checks);
      if (formula.name != by_formula || !formula.holds || !dynamic || *dynamic->holds == *formula.holds) continue;
      list.push_back({"routes_differ", formula.margin.value_or(0.), dynamic->margin.value_or(0.), "1",
                      "by formulas: " + text_of(formula) + "; by dynamics: " + text_of(*dynamic) +
                          ". These are two routes to one answer, and neither makes the other void: the worse governs. "
                          "Look at the peak of the load (peak_gain), its duration, the soils and mu before one of them "
                          "is believed"});
    }
  return list;
}

void judge(const Scene& scene, Summary& summary) {
  summary.checks = checks_of(scene, summary);
  NumberedWarnings& warnings = summary.warnings;
  const std::set<std::string> drawn = {"routes_differ", "no_rest", "rest_open"};  // from the checks, and so anew
  warnings.erase(std::remove_if(warnings.begin(), warnings.end(),
                                [&](const NumberedWarning& warning) { return drawn.count(warning.name) > 0; }),
                 warnings.end());
  append(warnings, rest_warnings(summary));
  append(warnings, route_warnings(summary.checks));
}

}  // namespace upbead
