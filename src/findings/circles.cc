// Slip circles through mound and ground under the caisson, at rest and at the moments of the waves that may govern.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/circle_ground.h"
#include "findings/effective_base.h"
#include "findings/topics.h"
#include "output/limits.h"
#include "upbead/rupture/circle_family.h"

namespace upbead {

namespace {

std::optional<double> leaves_time_of(const EffectiveBase& base, const std::vector<double>& time) {
  const auto first = first_without_stand(base.force, base.moment, base.width);
  return first ? std::optional(time[*first]) : std::nullopt;
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

struct Counts {
  int tried = 0, steep = 0;

  void add(const LookedFor& found) {
    tried += found.tried;
    steep += found.steep;
  }
};

/// The loads at these times and still water's push, as they act on the caisson without motion, as shear at its base.
std::vector<double> static_shear(const Evidence& e, const std::vector<double>& time) {
  const CompiledScene& compiled = *e.simulation.compiled();
  std::vector<double> list(time.size(), e.of(find_effective_base)->push);
  for (std::size_t i = 0; i < time.size(); ++i)
    for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k)
      list[i] += load_in_row(compiled.system.loads[k].history, time, i) * compiled.loads_on_caisson[k].force_x;
  return list;
}

void look_in_motion(const Evidence& e, const CircleGround& ground, const std::optional<PressureMap>& map,
                    SlipCircles& circles, Counts& counts) {
  const EffectiveBase& base = *e.of(find_effective_base);
  const std::vector<double>& time = e.of(find_history).series.time;
  const std::vector<BaseMoment> moments = moments_to_look_at(base, shear_of(e), time);
  const auto look = [&](std::optional<SlipCircleFound>& least, const std::function<PressureAt(double)>& pressure_at) {
    const LookedFor found = least_of_moments(ground, moments, pressure_at);
    least = found.least;
    counts.add(found);
  };
  look(circles.still, [](double) { return PressureAt(); });
  circles.leaves_time = leaves_time_of(base, time);
  if (map)
    look(circles.computed, [&map](double when) { return map->at(when); });
  else
    circles.why_not_computed = "the scene was marched, which keeps no pressures of all times";
}

/// The least circle under the loads without motion, and by how much more motion needs of the same strength.
void look_without_motion(const Evidence& e, const CircleGround& ground, SlipCircles& circles) {
  const Series& series = e.of(find_history).series;
  const std::vector<double>& time = series.time;
  const EffectiveBase base = loads_alone(e.simulation, *e.of(find_effective_base), series);
  const std::vector<BaseMoment> moments = moments_to_look_at(base, static_shear(e, time), time);
  circles.static_design = least_of_moments(ground, moments, [](double) { return PressureAt(); }).least;
  if (circles.static_design && circles.still && circles.still->factor > 0.)
    circles.dynamic_load_factor = circles.static_design->factor / circles.still->factor;
}

/// Slices enough for a picture, and for a factor to 1e-3.
constexpr int slices_drawn = 60;
/// Rows of the course of a factor, at most about.
constexpr std::size_t rows_of_course = 1000;

/// The least factor over time of the circles that were found, each held, its ends
/// at the loaded width where that is wider.
void follow_circles(const Evidence& e, const CircleGround& ground, const std::optional<PressureMap>& map,
                    SlipCircles& circles) {
  const SlipCircleFound& circle = *circles.governs;
  const bool by_computed = circles.by == "computed";
  const auto pressure_at = [&](double when) { return by_computed ? map->at(when) : PressureAt(); };
  circles.slices = slices_at(ground, circle, circle.time ? pressure_at(*circle.time) : PressureAt(), slices_drawn);
  const EffectiveBase& base = *e.of(find_effective_base);
  const std::vector<double>&time = e.of(find_history).series.time, shear = shear_of(e);
  const std::size_t stride = 1 + time.size() / rows_of_course;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (i % stride != 0 && !(circle.time && time[i] == *circle.time)) continue;
    const BaseMoment moment{time[i], base.force[i], shear[i], base.moment[i]};
    const PressureAt pressure = pressure_at(time[i]);
    double least = HUGE_VAL;
    for (const auto* held : {&circles.at_rest, &circles.still, &circles.computed})
      if (*held) least = std::min(least, widened_safety_at(ground, **held, moment, pressure).factor);
    circles.course.time.push_back(time[i]);
    circles.course.factor.push_back(std::isfinite(least) ? least : NAN);
  }
}

void set_block(const CircleGround& ground, const std::optional<PressureMap>& map, SlipCircles& circles) {
  const PressureAt pressure = circles.by == "computed" ? map->at(*circles.governs->time) : PressureAt();
  const auto found = least_block(ground, *circles.governs, pressure);
  if (!found) return;
  const auto& [x, y] = found->block;
  circles.block = SlipBlockFound{found->safety.factor, {x.begin(), x.end()}, {y.begin(), y.end()}, found->is_at_limit};
}

CirclesFound look_for_circles(const Evidence& e) {
  CirclesFound found;
  found.why_not = why_no_search(e);
  if (!found.why_not.empty()) return found;
  const EffectiveBase& base = *e.of(find_effective_base);
  const CircleGround ground(e.simulation);
  SlipCircles circles;
  const LookedFor at_rest = least_circle(ground, {{}, base.weight, base.push, base.weight_moment}, {});
  Counts counts{at_rest.tried, at_rest.steep};
  circles.at_rest = at_rest.least;
  std::optional<PressureMap> map;
  if (e.solution.pressures) map.emplace(e.simulation, *e.solution.pressures, grid_of(ground));
  look_in_motion(e, ground, map, circles, counts);
  circles.uncut = uncut_regions(ground.section);
  circles.share_steep = counts.tried > 0 ? static_cast<double>(counts.steep) / counts.tried : 0.;
  set_governing(circles);
  look_without_motion(e, ground, circles);
  if (circles.governs) {
    if (!circles.leaves_time) set_block(ground, map, circles);  // then the circle is not of the worst moment
    follow_circles(e, ground, map, circles);
  }
  found.circles = circles;
  return found;
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
  if (limit && !summary.circles->uncut.empty())
    list.push_back({"circles_open", summary.circles->governs->factor, *limit, "1",
                    "no circle cuts " + summary.circles->uncut +
                        ", which has no strength: a circle through it may have less than those that were tried",
                    "give it a table strength; where it is rock, nothing is wrong"});
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

/// A factor that suffices in still water's pressure is no result where the water of pores takes a part of the loads.
Check judged_by_water(const Check& check, const Scene& scene, const SlipCircles& circles) {
  const bool has_pores = std::any_of(scene.regions.begin(), scene.regions.end(),
                                     [](const auto& r) { return r.second.kind == RegionKind::porous; });
  if (circles.why_not_computed.empty() || !has_pores || !check.demand) return check;
  return in_doubt(check,
                  "F is " + significant(*check.demand, 4) +
                      " in still water's pressure, and that of the pores is not known: " + circles.why_not_computed);
}

Check block_check(const Scene& scene, const SlipBlockFound& block) {
  const Check check = held_to(
      check_of(FailureMode::slip_circles, "slip on a plane", "", block.factor, "circles.block.factor",
               about_uplift(scene) +
                   "; horizontal forces on a block between two wedges, at the moment and with the "
                   "pressure of the least circle, without Janbu's f_0" +
                   (block.at_limit ? "; an upper bound, as the block stands where the method or the search ends" : "")),
      scene.limits, &Limits::circles);
  if (!block.at_limit || (check.holds && !*check.holds)) return check;
  return not_checked(check, "the least block stands where the method or the search ends: F is at most " +
                                significant(block.factor, 3));
}

Checks circle_checks(const Scene& scene, const Summary& summary) {
  if (!summary.circles) {
    if (!scene.limits.circles) return {};
    return {not_checked(held_to(check_of(FailureMode::slip_circles, "slip circles", "", {}, "circles.factor", ""),
                                scene.limits, &Limits::circles),
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
  Check check = held_to(check_of(FailureMode::slip_circles, "slip circles", "", factor, "circles.factor", how),
                        scene.limits, &Limits::circles);
  if (!circles.governs) check = not_checked(check, "no circle has a factor");
  if (factor) check.balance = Balance{circles.governs->driving, *factor * circles.governs->driving, "N/m"};
  Checks list{judged_by_water(check, scene, circles)};
  if (circles.block) list.push_back(judged_by_water(block_check(scene, *circles.block), scene, circles));
  return list;
}

OutputSchema<SlipCircleFound> circle_outputs() {
  using C = SlipCircleFound;
  return OutputSchema<C>()
      .key("factor", &C::factor, "", "F by Bishop's simplified method")
      .key("driving", &C::driving, "N/m", "the moment that drives it over its radius; F times that resists")
      .key("time", &C::time, "s", "when; null at rest")
      .key("slips", &C::slips, "", "`landward` or `seaward`")
      .key("centre[]", &C::centre, "m", "of the circle")
      .key("radius", &C::radius, "m", "of the circle")
      .key("from", &C::from, "m", "x where it meets the surface on the left")
      .key("to", &C::to, "m", "and on the right")
      .key("force", &C::force, "N/m", "N' of the base then")
      .key("shear", &C::shear, "N/m", "F_T then, with the push of still water at two levels")
      .key("moment", &C::moment, "N m/m", "M' then, about the middle of the base")
      .key("strip_from", &C::strip_from, "m", "x of the left end of the effective width, which N' loads evenly")
      .key("strip_to", &C::strip_to, "m", "and of its right end");
}

OutputSchema<SlipBlockFound> block_outputs() {
  using B = SlipBlockFound;
  return OutputSchema<B>()
      .key("factor", &B::factor, "", "F by horizontal forces, on the safe side: without Janbu's factor f_0")
      .key("x[]", &B::x, "m", "of its four corners, from left to right")
      .key("y[]", &B::y, "m", "of these corners; the first and last are on the surface")
      .key("at_limit", &B::at_limit, "",
           "whether it stands where the method (m_alpha = 0.2) or the search ends: `factor` then is an upper bound");
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
              "`by`; null where none has a factor, and where the resultant leaves the base")
      .object("static_design", &C::static_design, circle_outputs(),
              "in the pressure of still water, under the loads as they act without motion: what a design without "
              "dynamics looks at; null where no circle has a factor")
      .key("dynamic_load_factor", &C::dynamic_load_factor, "",
           "`static_design.factor` over `still.factor`: how much more of the same strength the loads need by their "
           "motion (below 1: less); null where either is, and where soil bears nothing")
      .key("leaves_time", &C::leaves_time, "s",
           "when the resultant leaves the base, so that no effective width bears it; null where it stays")
      .reason("uncut", &C::uncut, "regions without a strength, which no circle cuts; null where there are none")
      .key(
          "share_steep", &C::share_steep, "",
          "share of the circles of the first grid that is left out: m_alpha below 0.2, where the method does not hold");
}

}  // namespace

std::optional<SlipCircles> find_circles(const Evidence& e) {
  return e.of(look_for_circles).circles;
}

std::string find_why_no_circles(const Evidence& e) {
  return e.of(look_for_circles).why_not;
}

std::vector<double> shear_of(const Evidence& e) {
  const auto row = e.of(find_history).series.reading.row(e.simulation.system().reading(reading::shear_force));
  const auto& base = e.of(find_effective_base);
  std::vector<double> shear(row.begin(), row.end());
  for (double& F : shear) F += base ? base->push : 0.;
  return shear;
}

Finding circles_finding() {
  Finding f;
  f.keys
      .object("circles", &Summary::circles, circles_outputs(),
              "[slip circles](circles.md) through mound and ground under the caisson; null where no region has a "
              "strength, and where `why_no_circles` says so")
      .reason("why_no_circles", &Summary::why_no_circles, "why not; null where they are there");
  f.warnings = circle_warnings;
  f.checks = circle_checks;
  return f.part(&Summary::circles, find_circles).part(&Summary::why_no_circles, find_why_no_circles);
}

}  // namespace upbead
