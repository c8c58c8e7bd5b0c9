// Slip circles through mound and ground under the caisson, at rest and at the moments of the waves that may govern.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/circle_ground.h"
#include "findings/topics.h"
#include "rupture/slip_block.h"
#include "upbead/rupture/circle_family.h"

namespace upbead {

namespace {

/// Whether and when the resultant leaves the base.
std::optional<double> leaves_time_of(const EffectiveBase& base, const std::vector<double>& time) {
  const auto first = first_without_stand(base.force, base.moment, base.width);
  return first ? std::optional(time[*first]) : std::nullopt;
}

std::vector<BaseMoment> moments_to_look_at(const EffectiveBase& base, const Eigen::RowVectorXd& shear,
                                           const std::vector<double>& time) {
  const std::vector<double> F(shear.begin(), shear.end());
  std::vector<BaseMoment> moments;
  for (const std::size_t i : moments_that_may_govern(base.force, base.moment, F, base.width))
    moments.push_back({time[i], base.force[i], F[i], base.moment[i]});
  return moments;
}

SlipCircleFound told(const FoundCircle& found, const BaseMoment& moment, const StripLoad& strip, SlipsTo slips) {
  SlipCircleFound s;
  s.factor = found.safety.factor;
  s.time = moment.time;
  s.slips = slips == SlipsTo::right ? "landward" : "seaward";
  s.centre = {found.circle.x, found.circle.y};
  s.radius = found.circle.radius;
  s.from = found.safety.from;
  s.to = found.safety.to;
  s.force = moment.force;
  s.shear = moment.shear;
  s.moment = moment.moment;
  s.strip_from = strip.from;
  s.strip_to = strip.to;
  return s;
}

struct Counts {
  int tried = 0, steep = 0;
};

/// The less safe of two.
std::optional<SlipCircleFound> worse(const std::optional<SlipCircleFound>& a, const std::optional<SlipCircleFound>& b) {
  if (!a || !b) return a ? a : b;
  return b->factor < a->factor ? b : a;
}

struct LookedFor {
  std::optional<SlipCircleFound> least;
  Counts counts;
};

/// The least circle of one moment. It slips to where the base is pushed or its resultant stands, and both ways where
/// these differ or neither is known.
LookedFor least_circle(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure,
                       const SearchOptions& options = {}) {
  LookedFor found;
  const std::optional<GroundLoads> loads = loads_of(ground, moment, pressure);
  if (!loads) return found;
  for (const SlipsTo slips : {SlipsTo::right, SlipsTo::left}) {
    if (!may_slip(moment, slips)) continue;
    const CircleSearch search =
        search_circles(ground.section, *loads, slips, range_beside(ground, *loads->strip), options);
    found.counts.tried += search.tried;
    found.counts.steep += search.steep;
    if (!search.family.empty()) found.least = worse(found.least, told(search.family[0], moment, *loads->strip, slips));
  }
  return found;
}

struct CirclesFound {
  std::optional<SlipCircles> circles;
  std::string why_not;
};

/// Why there is nothing to look for; "" where there is.
std::string why_no_search(const Evidence& e) {
  const std::string why = why_no_circles_in(e.simulation);
  if (!why.empty()) return why;
  if (!e.of(find_effective_base)) return "the caisson's weight in water is not known, see `base`";
  return "";
}

std::string uncut_regions(const GroundSection& section) {
  std::string names;
  for (const GroundSoil& soil : section.soils())
    if (!soil.may_fail) names += (names.empty() ? "" : ", ") + soil.name;
  return names;
}

/// Sets what governs, the least of what was found.
void set_governing(SlipCircles& circles) {
  for (const auto& [found, name] :
       {std::pair{&circles.at_rest, "at_rest"}, {&circles.still, "still"}, {&circles.computed, "computed"}}) {
    if (!*found || (circles.governs && circles.governs->factor <= (*found)->factor)) continue;
    circles.governs = *found;
    circles.by = name;
  }
}

/// Tells which moments the least circle may be of, before it is sought as far as it needs; it errs by some percent.
const SearchOptions rough{30, 60, {8, 14, 10}, 2};
constexpr double rough_error = 0.25;

LookedFor least_of_moments(const CircleGround& ground, const std::vector<BaseMoment>& moments,
                           const std::function<PressureAt(double time)>& pressure_at) {
  std::vector<double> roughly;
  for (const BaseMoment& moment : moments) {
    const LookedFor found = least_circle(ground, moment, pressure_at(*moment.time), rough);
    roughly.push_back(found.least ? found.least->factor : HUGE_VAL);
  }
  LookedFor all;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (roughly[i] > (1. + rough_error) * *std::min_element(roughly.begin(), roughly.end())) continue;
    const LookedFor found = least_circle(ground, moments[i], pressure_at(*moments[i].time));
    all.least = worse(all.least, found.least);
    all.counts.tried += found.counts.tried;
    all.counts.steep += found.counts.steep;
  }
  return all;
}

void look_in_motion(const Evidence& e, const CircleGround& ground, const std::optional<PressureMap>& map,
                    SlipCircles& circles, Counts& counts) {
  const EffectiveBase& base = *e.of(find_effective_base);
  const Series& series = e.of(find_history);
  const Eigen::RowVectorXd shear = series.reading.row(e.simulation.compiled()->system.reading(reading::shear_force));
  const std::vector<BaseMoment> moments = moments_to_look_at(base, shear, series.time);
  const auto look = [&](std::optional<SlipCircleFound>& least, const std::function<PressureAt(double)>& pressure_at) {
    const LookedFor found = least_of_moments(ground, moments, pressure_at);
    least = found.least;
    counts.tried += found.counts.tried;
    counts.steep += found.counts.steep;
  };
  look(circles.still, [](double) { return PressureAt(); });
  circles.leaves_time = leaves_time_of(base, series.time);
  if (map)
    look(circles.computed, [&map](double time) { return map->at(time); });
  else
    circles.why_not_computed = "the scene was marched, which keeps no pressures of all times";
}

/// The least block of the moment and pressure that govern, on planes down to two widths below the base.
std::optional<SlipBlockFound> least_block(const CircleGround& ground, const std::optional<PressureMap>& map,
                                          const SlipCircles& circles) {
  const SlipCircleFound& worst = *circles.governs;
  const PressureAt pressure = circles.by == "computed" ? map->at(*worst.time) : PressureAt();
  const auto loads = loads_of(ground, {worst.time, worst.force, worst.shear, worst.moment}, pressure);
  if (!loads) return std::nullopt;
  const double B = ground.right - ground.left;
  const auto found = search_blocks(ground.section, *loads, worst.slips == "landward" ? SlipsTo::right : SlipsTo::left,
                                   range_beside(ground, *loads->strip), {ground.level - 2. * B, ground.level});
  if (!found) return std::nullopt;
  const auto& [x, y] = found->block;
  return SlipBlockFound{found->safety.factor, {x.begin(), x.end()}, {y.begin(), y.end()}};
}

CirclesFound look_for_circles(const Evidence& e) {
  CirclesFound found;
  found.why_not = why_no_search(e);
  if (!found.why_not.empty()) return found;
  const EffectiveBase& base = *e.of(find_effective_base);
  const CircleGround ground(e.simulation);
  SlipCircles circles;
  const LookedFor at_rest = least_circle(ground, {{}, base.weight, 0., base.weight_moment}, {});
  Counts counts = at_rest.counts;
  circles.at_rest = at_rest.least;
  std::optional<PressureMap> map;
  if (e.solution.pressures) map.emplace(e.simulation, *e.solution.pressures, grid_of(ground));
  look_in_motion(e, ground, map, circles, counts);
  circles.uncut = uncut_regions(ground.section);
  circles.share_steep = counts.tried > 0 ? static_cast<double>(counts.steep) / counts.tried : 0.;
  set_governing(circles);
  if (circles.governs) circles.block = least_block(ground, map, circles);
  found.circles = circles;
  return found;
}

std::optional<SlipCircles> find_circles(const Evidence& e) {
  return e.of(look_for_circles).circles;
}

std::string find_why_no_circles(const Evidence& e) {
  return e.of(look_for_circles).why_not;
}

std::string when_of(const SlipCircleFound& found) {
  return found.time ? "at " + significant(*found.time) + " s" : "at rest";
}

/// Warning slip_circle: a circle has less than what it needs to stand; circles_open: a limit cannot be checked.
NumberedWarnings circle_warnings(const Evidence& e, const Summary& summary) {
  NumberedWarnings list;
  const auto& limit = e.scene.limits.circles;
  if (limit && !(summary.circles && summary.circles->governs))
    list.push_back(
        {"circles_open", 0., *limit, "1",
         "limits.circles is not checked: " + (summary.circles ? "no circle has a factor" : summary.why_no_circles),
         "give the regions under the caisson a table strength"});
  if (!summary.circles || !summary.circles->governs) return list;
  const SlipCircleFound& worst = *summary.circles->governs;
  if (worst.factor >= 1.) return list;
  list.push_back({"slip_circle", worst.factor, 1., "1",
                  when_of(worst) + " the ground under the caisson would slip " + worst.slips + " on a circle about " +
                      place_text(worst.centre) + " with radius " + with_unit(worst.radius, "m") +
                      ": F = " + significant(worst.factor) + " by Bishop's simplified method",
                  "widen the caisson or its berm, or give the mound more height; a factor below 1 of a moment is a "
                  "permanent displacement and not yet a collapse"});
  return list;
}

Checks circle_checks(const Scene& scene, const Summary& summary) {
  if (!summary.circles) {
    if (!scene.limits.circles) return {};
    return {not_checked(at_least_as(check_of("slip circles", "", {}, "circles.factor", ""), scene.limits.circles),
                        summary.why_no_circles)};
  }
  const SlipCircles& circles = *summary.circles;
  std::string how = about_uplift(scene) +
                    "; Bishop's simplified method, the load on the effective width, the circle with the least factor";
  if (!circles.uncut.empty()) how += "; none cuts " + circles.uncut + ", without a strength";
  if (!circles.why_not_computed.empty()) how += "; in still water's pressure alone: " + circles.why_not_computed;
  if (circles.governs) how += "; " + circles.governs->slips + ", " + when_of(*circles.governs);
  std::optional<double> factor;
  if (circles.governs && !circles.leaves_time) factor = circles.governs->factor;
  Check check = at_least_as(check_of("slip circles", "", factor, "circles.factor", how), scene.limits.circles);
  if (!circles.governs) check = not_checked(check, "no circle has a factor");
  Checks list{check};
  if (circles.block)
    list.push_back(at_least_as(
        check_of("slip on a plane", "", circles.block->factor, "circles.block.factor",
                 about_uplift(scene) + "; horizontal forces on a block between two wedges, at the moment and with "
                                       "the pressure of the least circle, without Janbu's f_0"),
        scene.limits.circles));
  return list;
}

OutputSchema<SlipCircleFound> circle_outputs() {
  using C = SlipCircleFound;
  return OutputSchema<C>()
      .key("factor", &C::factor, "", "F by Bishop's simplified method")
      .key("time", &C::time, "s", "when; null at rest")
      .key("slips", &C::slips, "", "`landward` or `seaward`")
      .key("centre[]", &C::centre, "m", "of the circle")
      .key("radius", &C::radius, "m", "of the circle")
      .key("from", &C::from, "m", "x where it meets the surface on the left")
      .key("to", &C::to, "m", "and on the right")
      .key("force", &C::force, "N/m", "N' of the base then")
      .key("shear", &C::shear, "N/m", "F_T then")
      .key("moment", &C::moment, "N m/m", "M' then, about the middle of the base")
      .key("strip_from", &C::strip_from, "m", "x of the left end of the effective width, which N' loads evenly")
      .key("strip_to", &C::strip_to, "m", "and of its right end");
}

OutputSchema<SlipBlockFound> block_outputs() {
  using B = SlipBlockFound;
  return OutputSchema<B>()
      .key("factor", &B::factor, "", "F by horizontal forces, on the safe side: without Janbu's factor f_0")
      .key("x[]", &B::x, "m", "of its four corners, from left to right")
      .key("y[]", &B::y, "m", "of these corners; the first and last are on the surface");
}

OutputSchema<SlipCircles> circles_outputs() {
  using C = SlipCircles;
  const auto factor = [](const C& c) { return c.governs ? std::optional(c.governs->factor) : std::nullopt; };
  return OutputSchema<C>()
      .key("factor", factor, "", "least F of the next three; null where there is none")
      .reason("by", &C::by, "which of them has it; null where there is none")
      .object("at_rest", &C::at_rest, circle_outputs(), "without waves; null where no circle has a factor")
      .object("still", &C::still, circle_outputs(), "in motion, with the pore pressure of still water")
      .object("computed", &C::computed, circle_outputs(), "in motion, with the pore pressure computed at that moment")
      .reason("why_not_computed", &C::why_not_computed, "why `computed` is null; null where it is there")
      .object("block", &C::block, block_outputs(),
              "a block that slips on a level plane between two wedges, at the moment and with the pressure of "
              "`by`; null where none has a factor")
      .key("leaves_time", &C::leaves_time, "s",
           "when the resultant leaves the base, so that no effective width bears it; null where it stays")
      .reason("uncut", &C::uncut, "regions without a strength, which no circle cuts; null where there are none")
      .key(
          "share_steep", &C::share_steep, "",
          "share of the circles of the first grid that is left out: m_alpha below 0.2, where the method does not hold");
}

}  // namespace

Finding circles_finding() {
  Finding f;
  f.keys = [](OutputSchema<Summary>& s) {
    s.object("circles", &Summary::circles, circles_outputs(),
             "[slip circles](circles.md) through mound and ground under the caisson; null where no region has a "
             "strength, and where `why_no_circles` says so")
        .reason("why_no_circles", &Summary::why_no_circles, "why not; null where they are there");
  };
  f.warnings = circle_warnings;
  f.checks = circle_checks;
  return f.part(&Summary::circles, find_circles).part(&Summary::why_no_circles, find_why_no_circles);
}

}  // namespace upbead
