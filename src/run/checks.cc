#include "run/checks.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

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

/// Completes a check whose demand must not exceed a capacity.
Check at_most(Check check, const std::optional<double>& capacity) {
  check.capacity = capacity;
  if (!capacity) return check;
  if (check.demand && *check.demand > 0.) check.margin = *capacity / *check.demand;
  check.holds = check.demand && *check.demand <= *capacity;
  return check;
}

/// Completes a check whose value must not fall below one.
Check at_least_as(Check check, const std::optional<double>& capacity) {
  check.capacity = capacity;
  if (!capacity) return check;
  check.margin = *check.demand / *capacity;
  check.holds = *check.demand >= *capacity;
  return check;
}

Check check_of(const std::string& name, const std::string& unit, const std::optional<double>& demand,
               const std::string& measure, const std::string& assumption) {
  Check check;
  check.name = name;
  check.unit = unit;
  check.demand = demand;
  check.measure = measure;
  check.assumption = assumption;
  return check;
}

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

}  // namespace

std::vector<Check> checks_of(const Scene& scene, const Summary& summary) {
  std::vector<Check> list;
  if (const auto& sliding = summary.sliding) {
    const std::string assumption = about_uplift(scene) + "; " + sliding->design.why;
    list.push_back(at_most(check_of("sliding distance", "m", std::abs(sliding->design.value), sliding->design.measure,
                                    (sliding->design.value < 0. ? "seaward; " : "") + assumption),
                           scene.limits.sliding));
    list.push_back(at_most(check_of("force against friction", "N/m", sliding->history.peak_force,
                                    "sliding.peak_sliding_force", about_uplift(scene) + "; F_T of the bonded caisson"),
                           sliding->history.resistance));
    list.push_back(
        at_most(check_of("force against friction, seaward", "N/m", std::max(sliding->history.peak_seaward, 0.),
                         "sliding.peak_sliding_force_seaward", about_uplift(scene) + "; F_T of the bonded caisson"),
                sliding->history.resistance));
  }
  if (summary.nonlinear && summary.residual) list.push_back(displacement_check(summary, scene.limits.sliding));
  if (const auto& base = summary.base) {
    const std::string linear = about_uplift(scene) + "; effective stress varies linearly over the width in contact";
    list.push_back(at_most(check_of("heel pressure", "Pa", base->peak_heel_pressure, "base.peak_heel_pressure", linear),
                           scene.limits.base_pressure));
    list.push_back(at_most(check_of("toe pressure", "Pa", base->peak_toe_pressure, "base.peak_toe_pressure", linear),
                           scene.limits.base_pressure));
    if (base->least_overturning_margin)
      list.push_back(at_least_as(check_of("margin against overturning", "", *base->least_overturning_margin,
                                          "base.least_overturning_margin", about_uplift(scene) + "; a rigid base"),
                                 scene.limits.overturning));
  }
  return list;
}

}  // namespace upbead
