// S by every measure, the one to design by, and the checks against friction.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/run_end.h"
#include "base/text.h"
#include "fem/caisson/bottom.h"
#include "fem/caisson/readings.h"
#include "findings/effective_base.h"
#include "findings/errors.h"
#include "findings/load_places.h"
#include "findings/topics.h"
#include "output/limits.h"
#include "output/sliding_outputs.h"
#include "response/shear_response.h"
#include "run/sliding/case_sliding.h"
#include "run/sliding/coupled_sliding.h"
#include "sliding/rest_velocity.h"
#include "upbead/base/error.h"
#include "upbead/model/load.h"

namespace upbead {

namespace {

/// The S by the measure with the most mechanics that the run has: friction node by node, else a caisson that slides
/// as a rigid block on the moving ground, else the larger of eq. (4) on F_T(t) with and without the vertical motion.
DesignSliding design_sliding(const SlidingSummary& s, const std::optional<ContactSummary>& contact,
                             const std::optional<ResidualSummary>& residual) {
  if (contact) return design_by_nodes(*contact);
  if (s.coupled)
    return {s.coupled->slip.residual, "sliding.sliding_coupled",
            s.coupled->vectors > 0 ? "the caisson slides as a rigid block on the moving ground"
                                   : "the bonded caisson does not reach mu N'",
            s.coupled->error_estimate, s.coupled->slip.largest};
  const Sliding &plain = s.history.by_history, &moved = s.history.with_normal_force;
  const std::string why = std::string("the larger of two by F_T(t) of the bonded caisson") +
                          (residual ? ", its slip over the mound alone: how far the ground carried it stands beside it "
                                      "(residual.displacement_x)"
                                    : "") +
                          "; slip with its ground could not be computed: ";
  return std::abs(plain.residual) >= std::abs(moved.residual)
             ? DesignSliding{plain.residual, "sliding.sliding_history", why + s.why_not_coupled, s.error_estimate,
                             plain.largest,  plain.end_velocity}
             : DesignSliding{moved.residual,          "sliding.sliding_normal_force",
                             why + s.why_not_coupled, {},
                             moved.largest,           moved.end_velocity};
}

std::string why_not_all(const DesignSliding& design, double tolerable) {
  if (std::abs(design.end_velocity) <= tolerable) return "";
  return "the caisson still slides when the run ends, at " + significant(design.end_velocity) +
         " m/s: S is no more than its way till then";
}

/// Whether a caisson that has slid comes to rest under the loads as they are at the end of the run: their force without
/// motion, with the push of still water, is at most mu N'. Else S is only the distance until then, and has no bound.
bool comes_to_rest(const Evidence& e, double S, double friction) {
  const std::optional<EffectiveBase>& base = e.of(find_effective_base);
  if (S == 0. || !base || is_shaken(e.scene)) return true;
  const Series& series = e.of(find_history).series;
  if (series.time.empty()) return true;
  const double normal = loads_alone(e.simulation, *base, series).force.back();
  const double end = e.scene.time.end;
  const double force = until_end(force_on_caisson(*e.simulation.compiled()), end, end) + base->push;
  return normal > 0. && std::abs(force) <= friction * normal;
}

/// The largest upward force of the loads on the caisson (N/m): mu W' lacks it, as it lacks an uplift.
double lift_of_loads(const Evidence& e) {
  const CompiledScene& compiled = *e.simulation.compiled();
  const std::vector<double>& time = e.of(find_history).series.time;
  double largest = 0.;
  for (std::size_t i = 0; i < time.size(); ++i) {
    double up = 0.;
    for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k)
      up += load_in_row(compiled.system.loads[k].history, time, i) * compiled.loads_on_caisson[k].force_y;
    largest = std::max(largest, up);
  }
  return largest;
}

/// Why a distance is not all where the loads go on after the run: the caisson still slipped in its last fifth; `stop`:
/// of its last slip (s).
std::string why_slips_on(const Evidence& e, double S, double stop) {
  constexpr double before_last_part = 0.8;
  if (S == 0. || !loads_go_on(e.simulation) || stop < before_last_part * e.scene.time.end) return "";
  return "the loads go on after the run, in whose last fifth the caisson still slipped: S is no more than its way till "
         "then";
}

/// Until when the bottom as a whole slips by more than a tolerable part of S (s); nodes at its edges creep on.
double last_slip(const ContactHistory& history) {
  const std::size_t n = history.length.size();
  const double width = std::accumulate(history.length.begin(), history.length.end(), 0.);
  const auto mean = [&](std::size_t step) {
    return std::inner_product(history.length.begin(), history.length.end(),
                              history.slip.begin() + static_cast<std::ptrdiff_t>(step * n), 0.) /
           width;
  };
  const std::size_t last = history.time.size() - 1;
  for (std::size_t step = last; step-- > 0;)
    if (std::abs(mean(step) - mean(last)) > tolerable_rest * std::abs(mean(last))) return history.time[step + 1];
  return 0.;
}

/// Until when it slips of which S to design by is (s).
double end_of_slip(const Evidence& e, const SlidingSummary& sliding) {
  const auto& contact = e.solution.contact;
  if (contact && contact->found.solved) return contact->history ? last_slip(*contact->history) : 0.;
  const std::vector<Slip>& slips = sliding.coupled ? sliding.coupled->slip.slips : sliding.history.by_history.slips;
  return slips.empty() ? 0. : slips.back().stop;
}

/// Adds whether the caisson comes to rest, and why the distance is not all.
DesignSliding with_end(const Evidence& e, DesignSliding design, double friction, double stop) {
  design.rests = comes_to_rest(e, design.value, friction);
  if (design.rests)
    design.why_not_all = why_not_all(design, tolerable_velocity(friction, e.scene.gravity, design.value));
  if (design.rests && design.why_not_all.empty()) design.why_not_all = why_slips_on(e, design.value, stop);
  if (const std::string& why = e.of(find_why_void); !why.empty()) design.why = "void: " + why + "; " + design.why;
  return design;
}

/// The S to design by: of [sliding], or of friction node by node without that table; none where the case has neither.
std::optional<DesignSliding> design_of(const Scene& scene, const Summary& summary) {
  if (summary.sliding) return summary.sliding->design;
  if (!summary.contact) return std::nullopt;
  DesignSliding design = design_by_nodes(*summary.contact);
  design.why_not_all = why_not_all(design, tolerable_velocity(summary.contact->friction, scene.gravity, design.value));
  return design;
}

std::optional<SlidingSummary> find_sliding(const Evidence& e) {
  std::optional<SlidingSummary> sliding = e.of(find_slid);
  if (!sliding) return sliding;
  const SlipAsWhole& whole = e.of(find_slip_as_whole);
  const Errors& errors = e.of(find_errors);
  sliding->coupled = whole.coupled;
  sliding->why_not_coupled = whole.why_not;
  sliding->coupled_failed = whole.failed;
  sliding->lift_of_loads = lift_of_loads(e);
  sliding->error_estimate = errors.slip;
  sliding->why_no_estimate = errors.why_no_slip;
  if (sliding->coupled) sliding->coupled->error_estimate = errors.slip_as_whole;
  sliding->design = with_end(e, design_sliding(*sliding, e.of(find_contact), e.of(find_residual)), sliding->friction,
                             end_of_slip(e, *sliding));
  return sliding;
}

/// Warning slides_on: S is only how far the caisson came until the run ended.
NumberedWarnings warnings_of_endless(const DesignSliding& design, bool judged) {
  return {{"slides_on", design.value, 0., "m",
           "at the end of the run the loads exceed the friction, or lift the caisson: it slides on, and all S here are "
           "only how far it came until then, " +
               with_unit(design.value, "m") + " by " + design.measure,
           "let the run end after its loads (time.end); where they stay, as an uplift that is held, the section does "
           "not stand",
           !judged}};
}

/// Warning still_slides: the run ends before the caisson rests.
NumberedWarnings warnings_of_end(const Evidence& e, const DesignSliding& design, double friction) {
  if (design.why_not_all.empty()) return {};
  return {{"still_slides", std::abs(design.end_velocity), tolerable_velocity(friction, e.scene.gravity, design.value),
           "m/s", design.why_not_all + ", and the distance is not judged where it is within its limit",
           "let the run end after its loads (time.end); under loads that never end S grows with the run",
           !e.scene.limits.sliding || !e.scene.sliding}};
}

/// Warning uplift_left_out: the modelled pore pressure lifts the caisson, and [sliding] counts no uplift.
NumberedWarnings warnings_of_pores(const Evidence& e, const SlidingSummary& sliding) {
  constexpr double counts = 0.05;  // of W'
  if (e.scene.sliding->uplift || e.solution.contact) return {};
  const Series& series = e.of(find_history).series;
  const double U = series.reading.row(e.simulation.system().reading(reading::uplift)).maxCoeff();
  if (!(U > counts * sliding.submerged_weight)) return {};
  return {{"uplift_left_out", U, counts * sliding.submerged_weight, "N/m",
           "the pore pressure under the base lifts the caisson with up to " + with_unit(U, "N/m") +
               ", and [sliding] has no uplift: force against friction and S by eq. (4) leave it out",
           "write sliding.uplift = { kind = \"computed\" }",
           sliding.history.peak_force + sliding.friction * U > sliding.history.resistance}};
}

/// Warning drag_left_out: S to design by knows no F_D.
NumberedWarnings drag_warnings(const SlidingSummary& sliding) {
  const DesignSliding& design = sliding.design;
  if (sliding.drag == 0. || design.value == 0. || design.measure.rfind("sliding.sliding_history", 0) == 0) return {};
  return {{"drag_left_out", sliding.drag, 0., "N s/m2",
           "sliding.drag acts in eq. (4) alone, and S to design by, " + design.measure +
               ", has none of it: a drag that brakes makes it too large",
           "compare with sliding.sliding_history, which has that drag, or leave it out"}};
}

/// Warning bottom_not_level: friction, S and pressures are those of a level bottom.
NumberedWarnings bottom_warnings(const Evidence& e) {
  if (bottom_is_level(*e.simulation.mesh())) return {};
  return {
      {"bottom_not_level", 0., 0., "",
       "the caisson's bottom is not level: force against friction, S, eccentricity and edge pressures are those of a "
       "level one, and downhill it slides at less than mu W'",
       "level the bottom in the mesh; for a slope alpha take tan(phi - alpha) as friction, phi = arctan mu", true}};
}

/// Warning sliding_not_judged: no [sliding] asks for what the bonded caisson would do.
NumberedWarnings warnings_of_no_sliding(const Evidence& e, const Summary& summary) {
  const std::optional<EffectiveBase>& base = e.of(find_effective_base);
  if (!base || !summary.response) return {};
  const double mu = contact_friction(e.scene), resistance = mu * base->weight;
  const double force = std::max(summary.response->peak_shear, -summary.response->peak_shear_seaward);
  if (force <= resistance) return {};
  return {{"sliding_not_judged", force, resistance, "N/m",
           "F_T comes to " + with_unit(force, "N/m") + ", more than " + significant(mu) +
               " W' = " + with_unit(resistance, "N/m") +
               ", and the case has no [sliding]: nothing of the run judges whether the caisson slides",
           "add [sliding] with friction and submerged_weight", true}};
}

/// Whether and when a slip node by node ends, where no [sliding] has told that.
DesignSliding followed_to_its_end(const Evidence& e, const ContactSummary& contact) {
  const auto& history = e.solution.contact->history;
  return with_end(e, design_by_nodes(contact), contact.friction, history ? last_slip(*history) : 0.);
}

/// Warning no_coupled_slip: the coupled S would not be right.
NumberedWarnings slip_warnings(const Evidence& e, const Summary& summary) {
  if (!summary.sliding && !summary.contact) return warnings_of_no_sliding(e, summary);
  const bool judged = summary.sliding.has_value();
  const DesignSliding design = judged ? summary.sliding->design : followed_to_its_end(e, *summary.contact);
  NumberedWarnings list = bottom_warnings(e);
  if (judged) append(list, drag_warnings(*summary.sliding));
  if (!design.rests) {
    append(list, warnings_of_endless(design, judged));
    return list;
  }
  append(list, warnings_of_end(e, design, judged ? summary.sliding->friction : summary.contact->friction));
  if (!judged) return list;
  append(list, warnings_of_pores(e, *summary.sliding));
  if (!summary.sliding->coupled_failed) return list;
  const SlidingSummary& sliding = *summary.sliding;
  list.push_back(
      {"no_coupled_slip", sliding.history.ratio, 1., "1",
       "the bonded caisson reaches its friction, but the distance that it slides as a rigid block on its ground could "
       "not be computed: " +
           sliding.why_not_coupled,
       "take S from sliding_history, or from contact node by node (kind = \"friction\")"});
  return list;
}

/// The slips that did not need to be computed, and why.
SkippedList skipped_slips(const Evidence&, const Summary& summary) {
  if (!summary.sliding) return {};
  const SlidingSummary& sliding = *summary.sliding;
  const std::string what = "slip of the caisson with its ground";
  if (!sliding.why_not_coupled.empty()) return {{what, sliding.why_not_coupled}};
  if (sliding.coupled && sliding.coupled->vectors == 0)
    return {{what, "|F_T| stays below mu N' at all times: the bonded caisson does not slip"}};
  return {};
}

/// What still water at two levels adds to a force in that direction (1: landward).
double still_push(const Summary& summary, double side) {
  return summary.harbour && !summary.harbour->counted ? side * summary.harbour->push : 0.;
}

/// What the loads lift takes off mu W'.
double lost_friction(const Summary& summary) {
  return summary.sliding->friction * summary.sliding->lift_of_loads;
}

std::string about_push(const Scene& scene, const Summary& summary) {
  const std::string push = summary.harbour ? ", with the push of still water at two levels (harbour.push)" : "";
  if (is_shaken(scene)) return push + ", less mu times the change of N' by the caisson's vertical motion";
  const double lost = lost_friction(summary);
  if (lost <= 1e-9 * summary.sliding->history.resistance) return push;
  return push + ", and " + with_unit(lost, "N/m") + ", mu times the largest force of the loads upward";
}

constexpr double no_force = 1e-6;  // of the largest P

/// What mu W' is held to in that direction (1: landward): F_T and mu U, and what the loads lift; where the ground
/// shakes, what the caisson's vertical motion takes off N', too.
double sliding_demand(const Scene& scene, const Summary& summary, double side) {
  const HistorySliding& history = summary.sliding->history;
  const double force = side > 0. ? history.peak_force : history.peak_seaward,
               on_normal = side > 0. ? history.peak_on_normal : history.peak_seaward_on_normal;
  return still_push(summary, side) + (is_shaken(scene) ? on_normal : force + lost_friction(summary));
}

std::string demand_key(const Scene& scene, bool landward) {
  const std::string force = is_shaken(scene) ? "sliding.peak_force" : "sliding.peak_sliding_force";
  return force + (landward ? "" : "_seaward") + (is_shaken(scene) ? "_on_normal" : "");
}

/// Where loads push the other way alone (1: landward), a friction that suffices for the rebound says nothing of the
/// direction; loads that only lift have none.
Check friction_check(const Scene& scene, const Summary& summary, double side, const std::string& assumption) {
  const bool landward = side > 0.;
  const double demand = sliding_demand(scene, summary, side);
  const Check check =
      at_most(check_of(landward ? FailureMode::sliding : FailureMode::sliding_seaward,
                       landward ? "force against friction" : "force against friction, seaward", "N/m",
                       landward ? demand : std::max(demand, 0.), demand_key(scene, landward), assumption),
              summary.sliding->history.resistance);
  const ShearResponse& r = *summary.response;
  const double that_way = landward ? r.peak_force : -r.peak_force_seaward,
               other_way = landward ? -r.peak_force_seaward : r.peak_force;
  const bool rebounds = that_way <= no_force * other_way && other_way > 0.;
  if (!rebounds || summary.loads_elsewhere || is_shaken(scene)) return check;
  return in_doubt(check, std::string(landward ? "no load pushes the caisson landward"
                                              : "no trough acts: no load pushes the caisson seaward") +
                             ", and its rebound, " + with_unit(*check.demand, "N/m") + about_push(scene, summary) +
                             ", stays below mu W'" +
                             (landward || summary.formula_checks.empty() ? "" : "; the trough is checked by formulas"));
}

/// A distance that is no more than the way till the end of the run may be too much already, but is never little enough.
Check judged(const Check& check, const DesignSliding& design) {
  return design.why_not_all.empty() || (check.holds && !*check.holds) ? check : not_checked(check, design.why_not_all);
}

/// Without bound where the caisson slides on, which exceeds a limit that nobody gave, too.
Check distance_check(const Scene& scene, const DesignSliding& design, const std::string& uplift) {
  const std::optional<double> distance = design.rests ? std::optional(std::abs(design.value)) : std::nullopt;
  const Check check = held_to(check_of(FailureMode::sliding_distance, "sliding distance", "m", distance, design.measure,
                                       (design.value < 0. ? "seaward; " : "") + uplift + "; " + design.why +
                                           (distance ? "" : "; it still slides at the end of the run")),
                              scene.limits, &Limits::sliding, distance ? std::nullopt : std::optional(0.));
  return judged(check, design);
}

/// Where the caisson was on the way and is no more: waves brought it back, and the next ones need not.
Checks checks_on_the_way(const Scene& scene, const DesignSliding& design, const std::string& measure,
                         const std::string& uplift) {
  constexpr double farther = 1.1;  // than where it comes to rest
  const double largest = std::abs(design.largest), value = std::abs(design.value);
  const bool fails_alone = scene.limits.sliding && largest > *scene.limits.sliding && value <= *scene.limits.sliding;
  if (!design.rests || (largest <= farther * value && !fails_alone)) return {};
  const Check check = check_of(FailureMode::sliding_distance, "sliding distance on the way", "m", largest, measure,
                               (design.largest < 0. ? "seaward; " : "") + uplift + "; " + design.why);
  return {judged(held_to(check, scene.limits, &Limits::sliding), design)};
}

Checks friction_checks(const Scene& scene, const Summary& summary, const std::string& uplift) {
  const std::string of_bonded =
      uplift + "; F_T of the bonded caisson" +
      (is_solved_with_friction(summary) ? ", before its friction was followed node by node" : "") +
      about_push(scene, summary);
  return {friction_check(scene, summary, 1., of_bonded), friction_check(scene, summary, -1., of_bonded)};
}

Checks sliding_checks(const Scene& scene, const Summary& summary) {
  const std::optional<DesignSliding> design = design_of(scene, summary);
  if (!design || !summary.response) return {};
  const std::string uplift = about_uplift(scene);
  Checks list{distance_check(scene, *design, uplift)};
  append(list, checks_on_the_way(scene, *design,
                                 summary.sliding ? "sliding.design.largest" : "contact.solved.largest_slip", uplift));
  if (summary.sliding) append(list, friction_checks(scene, summary, uplift));
  for (Check& check : list) check.has_rival = true;
  return list;
}

}  // namespace

const Solution& bonded_of(const Evidence& e) {
  const auto& contact = e.solution.contact;
  return contact && contact->bonded ? *contact->bonded : e.solution;
}

std::optional<SlidingSummary> find_slid(const Evidence& e) {
  const Solution& bonded = bonded_of(e);
  return sliding_of(e.scene, *bonded.simulation->compiled(), bonded.response);
}

SlipAsWhole find_slip_as_whole(const Evidence& e) {
  SlipAsWhole whole;
  const std::optional<SlidingSummary>& slid = e.of(find_slid);
  if (!slid) return whole;
  const Solution& bonded = bonded_of(e);
  if (slid->history.with_normal_force.slips.empty()) {  // below its friction at all times, which needs no work
    whole.coupled.emplace();
    const ShearResponse& shear = *bonded.found->of(bonded, find_shear);
    whole.coupled->peak_shear = std::max(shear.peak_shear, -shear.peak_shear_seaward);
    whole.coupled->least_normal = slid->history.least_normal_force;
    return whole;
  }
  whole.why_not = why_no_slip(*bonded.simulation);
  if (!whole.why_not.empty()) return whole;
  try {
    whole.coupled = slide_as_whole(*bonded.simulation, bonded.ahead.get(), bonded.response.ends, e.progress);
  } catch (const NumericsError& error) {
    whole.why_not = error.what();
    whole.failed = true;
  }
  return whole;
}

std::string about_uplift(const Scene& scene) {
  if (!scene.sliding || !scene.sliding->uplift) return "no uplift";
  const UpliftChoice& uplift = *scene.sliding->uplift;
  if (uplift.kind == UpliftKind::computed) return "uplift by the computed pore pressure";
  if (!uplift.peak) return "uplift as given over time";
  return uplift.course == UpliftCourse::held ? "uplift held at its peak" : "uplift in phase with P";
}

/// Whether a boundary's motion drives the scene: then F_T goes both ways without a trough.
bool is_shaken(const Scene& scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(),
                     [](const auto& load) { return is_motion(load.second.kind) && load.second.factor != 0.; });
}

DesignSliding design_by_nodes(const ContactSummary& contact) {
  if (!contact.solved) return {0., "contact.solved", "no node of the bonded base reaches its friction or pulls", {}};
  const NodeContact& solved = *contact.solved;
  return {solved.slip,           "contact.solved.slip", "friction is followed node by node",
          solved.error_estimate, solved.largest_slip,   solved.end_velocity};
}

Finding sliding_finding() {
  Finding f;
  f.keys.object(
      "sliding", &Summary::sliding, sliding_outputs(),
      "with `[sliding]` in the case, else null. Eq. numbers are those of Shimosako and Takahashi (1994); F_S = "
      "F_T + mu U. In `sliding_coupled` alone the slip acts back on the scene; for all other numbers F_T is "
      "that of a caisson bonded to its mound");
  f.warnings = slip_warnings;
  f.skipped = skipped_slips;
  f.checks = sliding_checks;
  return f.part(&Summary::sliding, find_sliding);
}

}  // namespace upbead
