// By which factor the strength of the ground may fall while the base presses on it as at the peak of the wave.
#include <cmath>

#include "base/progress.h"
#include "base/text.h"
#include "fem/compile.h"
#include "fem/loaded_ground.h"
#include "findings/circle_ground.h"
#include "findings/topics.h"
#include "output/limits.h"

namespace upbead {

namespace {

struct PeakFound {
  std::optional<PeakSafety> safety;
  std::string why_not;
};

/// The circle that governs in motion; none where none has a factor.
const SlipCircleFound* governing_in_motion(const SlipCircles& circles) {
  const auto &still = circles.still, &computed = circles.computed;
  if (computed && (!still || computed->factor <= still->factor)) return &*computed;
  return still ? &*still : nullptr;
}

/// The moment of that circle first.
std::vector<BaseMoment> moments_from(const Evidence& e, const SlipCircleFound& circle) {
  std::vector<BaseMoment> list{{circle.time, circle.force, circle.shear, circle.moment}};
  for (const BaseMoment& moment :
       moments_to_look_at(*e.of(find_effective_base), shear_of(e), e.of(find_history).series.time))
    if (moment.time != circle.time) list.push_back(moment);
  return list;
}

LoadedMoment loaded(const Evidence& e, const BaseMoment& moment, const std::optional<PressureMap>& map) {
  const Caisson& caisson = *e.simulation.compiled()->caisson;
  LoadedMoment m;
  m.base = {moment.force, moment.shear, moment.moment, caisson.bottom_centre, caisson.bottom_width};
  if (!map) return m;
  m.pores = e.simulation.space().get();
  m.pressure = map->at_nodes(*moment.time);
  return m;
}

/// The least circle and block at the worst moment, beside which the factor stands.
void set_circle(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure, PeakSafety& found) {
  const auto circle = least_circle(ground, moment, pressure).least;
  if (!circle) return;
  found.circle = circle->factor;
  if (const auto block = least_block(ground, *circle, pressure)) found.block = block->safety.factor;
}

PeakSafety peak_safety_of(const LoadedSafety& safety, const BaseMoment& moment, std::size_t n, bool by_computed) {
  PeakSafety found;
  found.lower = safety.lower;
  found.upper = safety.upper;
  found.time = *moment.time;
  found.pressure = by_computed ? "computed" : "still";
  found.force = moment.force;
  found.shear = moment.shear;
  found.moment = moment.moment;
  found.fails_at = safety.fails_at;
  found.moves = safety.moves;
  found.centre = safety.centre;
  found.depth = safety.depth;
  found.moments = static_cast<int>(n);
  found.why_open = safety.why;
  return found;
}

PeakFound seek_peak_safety(const Evidence& e) {
  if (!e.scene.limits.peak_safety) return {};
  const auto& circles = e.of(find_circles);
  if (!circles) return {{}, e.of(find_why_no_circles)};
  if (circles->leaves_time)
    return {{}, "the resultant leaves the base at " + significant(*circles->leaves_time) + " s, and nothing bears it"};
  const SlipCircleFound* circle = governing_in_motion(*circles);
  if (!circle) return {{}, "no circle has a factor in motion, by which its moment is chosen"};
  const CircleGround ground(e.simulation);
  std::optional<PressureMap> map;
  if (circles->computed && circle == &*circles->computed)
    map.emplace(e.simulation, *e.solution.pressures, grid_of(ground));
  const std::vector<BaseMoment> moments = moments_from(e, *circle);
  std::vector<LoadedMoment> loads;
  for (const BaseMoment& moment : moments) loads.push_back(loaded(e, moment, map));
  const LoadedSafety safety = safety_factor_under(loads, e.scene, *e.simulation.mesh(), e.simulation.soil_state(),
                                                  circle->factor, shown_progress("strength reduction at the peak"));
  const BaseMoment& worst = moments[safety.moment];
  PeakFound found{peak_safety_of(safety, worst, moments.size(), map.has_value()), ""};
  set_circle(ground, worst, map ? map->at(*worst.time) : PressureAt(), *found.safety);
  return found;
}

std::optional<PeakSafety> find_peak_safety(const Evidence& e) {
  return e.of(seek_peak_safety).safety;
}

std::string find_why_no_peak_safety(const Evidence& e) {
  return e.of(seek_peak_safety).why_not;
}

std::string told_failure(const PeakSafety& s) {
  std::string text = "at " + significant(s.time) + " s";
  if (s.moves.empty()) return text;
  text += " it fails in " + s.fails_at + ", the base " + s.moves;
  if (s.depth) text += ", 95 % of the shearing above " + with_unit(*s.depth, "m") + " below it";
  if (s.circle) text += "; the least circle then has " + significant(*s.circle, 3);
  return text;
}

constexpr double same_factor = 0.1;

/// Warnings peak_safety_open: no bound, or none close enough, was found; circles_differ: what strength reduction and
/// circles say of one moment differs by more than a tenth.
NumberedWarnings peak_warnings(const Evidence& e, const Summary& summary) {
  const auto& limit = e.scene.limits.peak_safety;
  if (!limit) return {};
  if (!summary.peak_safety)
    return {{"peak_safety_open", 0., *limit, "1", "limits.peak_safety is not checked: " + summary.why_no_peak_safety,
             "see why, or leave that limit out"}};
  const PeakSafety& s = *summary.peak_safety;
  NumberedWarnings list;
  if (!s.why_open.empty())
    list.push_back({"peak_safety_open", s.lower.value_or(0.), *limit, "1",
                    "the factor of strength at the peak of the wave is known less well than to 0.5 %: " + s.why_open,
                    "try mesh.refine = 1, or another size of cells"});
  if (s.circle && s.lower && std::abs(*s.lower / *s.circle - 1.) > same_factor)
    list.push_back({"circles_differ", *s.lower, *s.circle, "1",
                    "strength reduction gives " + significant(*s.lower, 3) + " " + told_failure(s) +
                        ": figures of another kind, or cells too coarse for a narrow band",
                    "halve the cells until the factor stays; the smaller of the two governs"});
  append(list, reduction_warnings(e.simulation, "limits.peak_safety", s.lower, limit));
  return list;
}

Checks peak_checks(const Scene& scene, const Summary& summary) {
  if (!scene.limits.peak_safety) return {};
  std::optional<double> factor;
  std::string how =
      "factor by which the strength may fall while the base presses as at the moment that governs; rigid caisson "
      "bonded to its mound, no inertia of the ground; of this mesh: coarse cells give too large ones";
  if (summary.peak_safety) {
    const PeakSafety& s = *summary.peak_safety;
    const bool falls = !s.lower && s.upper && *s.upper < *scene.limits.peak_safety;
    factor = falls ? s.upper : s.lower;
    if (falls)
      how += "; at most that, as it does not bear it with " + significant(1. / *s.upper, 3) +
             " times its strength: where that is a surface beside the caisson, the pore pressure lifts it, see "
             "limits.liquefaction";
    how += "; " + told_failure(s) + "; pore pressure: " + s.pressure;
    if (!s.why_open.empty()) how += "; " + s.why_open;
  }
  Check check = held_to(check_of(FailureMode::strength, "strength at the peak", "", factor, "peak_safety.lower", how),
                        scene.limits, &Limits::peak_safety);
  const bool leaves = summary.circles && summary.circles->leaves_time;
  if (!summary.peak_safety && !leaves) check = not_checked(check, summary.why_no_peak_safety);
  return {check};
}

OutputSchema<PeakSafety> peak_outputs() {
  using S = PeakSafety;
  const auto centre = [](const S& s) {
    const bool turns = std::isfinite(s.centre[0]) && std::isfinite(s.centre[1]) && !s.moves.empty();
    return turns ? std::vector<double>{s.centre[0], s.centre[1]} : std::vector<double>{};
  };
  return OutputSchema<S>()
      .key("lower", &S::lower, "", "largest factor at which the ground was found to bear it; null where none was found")
      .key("upper", &S::upper, "", "smallest factor at which it was shown that it does not; null where none was shown")
      .key("time", &S::time, "s", "the worst of the moments that were looked at")
      .key("pressure", &S::pressure, "", "in the pores: `still` or `computed`, that of the circle that governs")
      .key("force", &S::force, "N/m", "N' of the base then")
      .key("shear", &S::shear, "N/m", "F_T then")
      .key("moment", &S::moment, "N m/m", "M' then, about the middle of the base")
      .key("fails_at", &S::fails_at, "", "where it shears most as it fails; empty where it does not")
      .reason("moves", &S::moves, "how the base moves as it fails: `slides landward`, `turns landward`, `sinks`")
      .key("centre[]", centre, "m", "about which the base turns then; empty where it does not fail")
      .key("depth", &S::depth, "m",
           "below the base, above which 95 % of that shearing takes place, by middles of cells")
      .key("circle", &S::circle, "", "F of the least circle at that moment, with the same pore pressure")
      .key("block", &S::block, "", "F of the least block on a level plane, likewise")
      .key("moments", &S::moments, "", "moments that were looked at, those of the circles")
      .reason("why_open", &S::why_open,
              "why the bounds are more than 0.5 % apart, or missing; null where they are not");
}

}  // namespace

Finding peak_safety_finding() {
  Finding f;
  f.keys
      .object("peak_safety", &Summary::peak_safety, peak_outputs(),
              "factor by which [strength may fall at the peak of the wave](peak-strength.md), where "
              "`limits.peak_safety` asks for it; else null")
      .reason("why_no_peak_safety", &Summary::why_no_peak_safety,
              "why it was not found though asked for; null where it was");
  f.warnings = peak_warnings;
  f.checks = peak_checks;
  return f.part(&Summary::peak_safety, find_peak_safety).part(&Summary::why_no_peak_safety, find_why_no_peak_safety);
}

}  // namespace upbead
