// Momentary liquefaction of the ground beside the caisson: pore pressure that lifts what lies above it.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/compile.h"
#include "findings/circle_ground.h"
#include "findings/topics.h"
#include "output/limits.h"
#include "run/monitors.h"

namespace upbead {

namespace {

using Vertical = UpwardPressure::Vertical;

struct LiquefactionFound {
  std::optional<Liquefaction> liquefaction;
  std::string why_not;
};

std::string side_of(const Simulation& simulation, double x) {
  const auto& caisson = simulation.compiled()->caisson;
  return !caisson ? "" : x < caisson->bottom_centre[0] ? "sea" : "harbour";
}

LiquefiedPlace& place_of(Liquefaction& all, const std::string& region, const std::string& side) {
  for (LiquefiedPlace& place : all.places)
    if (place.region == region && place.side == side) return place;
  all.places.emplace_back();
  all.places.back().region = region;
  all.places.back().side = side;
  return all.places.back();
}

/// Zen and Yamazaki (1990): the ground above a point is lifted where p - p_b exceeds s'_v at rest.
void take_point(const UpwardPressure::Point& point, const Vertical& vertical, double stress, LiquefiedPlace& place) {
  if (!(point.largest > 0.)) return;
  if (point.largest >= stress && point.depth > place.depth) {
    place.depth = point.depth;
    place.depth_x = vertical.x;
    place.depth_time = point.time;
  }
  if (place.factor && stress / point.largest >= *place.factor) return;
  place.factor = stress / point.largest;
  place.pressure = point.largest;
  place.stress = stress;
  place.at = {vertical.x, point.y};
  place.below = point.depth;
  place.time = point.time;
  place.cell = vertical.cell;
}

double largest_at(const Vertical& vertical, double depth) {
  double before = 0., value = 0.;
  for (const auto& point : vertical.points) {
    if (point.depth >= depth) return value + (point.largest - value) * (depth - before) / (point.depth - before);
    before = point.depth;
    value = point.largest;
  }
  return value;
}

/// A straight course over two cells would have twice the pressure at the second one's end.
constexpr double straight_growth = 1.5;

std::string too_coarse(const LiquefiedPlace& worst, const std::vector<Vertical>& verticals) {
  const auto at =
      std::find_if(verticals.begin(), verticals.end(), [&](const Vertical& v) { return v.x == worst.at[0]; });
  if (at == verticals.end() || worst.below > 1.001 * worst.cell) return "";
  if (largest_at(*at, 2. * worst.cell) >= straight_growth * largest_at(*at, worst.cell)) return "";
  return "the pressure bends within the uppermost cell, " + with_unit(worst.cell, "m") + " high";
}

std::string why_no_pressure(const Evidence& e) {
  const Monitors& monitors = *e.of(monitors_of);
  if (!monitors.upward) return "several processes share the work";
  if (monitors.upward->verticals().empty()) return "no pores meet a surface of the ground";
  if (!monitors.upward->has_seen()) return "no state of the pores was kept";
  return "";
}

LiquefactionFound look_for_liquefaction(const Evidence& e) {
  LiquefactionFound found;
  if (!e.scene.limits.liquefaction) return found;
  found.why_not = why_no_pressure(e);
  if (!found.why_not.empty()) return found;
  const std::vector<Vertical>& verticals = e.of(monitors_of)->upward->verticals();
  const GroundSection section = ground_section(e.simulation);
  const auto surcharge = surcharge_of(e.simulation);
  Liquefaction& all = found.liquefaction.emplace();
  for (const Vertical& v : verticals) {
    const auto column = section.column(v.x);
    if (!column || !column->is_whole || std::abs(column->surface() - v.top) > 1e-6 * (1. + std::abs(v.top))) continue;
    for (const auto& point : v.points)
      take_point(point, v, section.weight_above(*column, point.y).force + (surcharge ? surcharge(v.x) : 0.),
                 place_of(all, e.simulation.mesh()->surfaces[point.surface], side_of(e.simulation, v.x)));
  }
  for (const LiquefiedPlace& place : all.places) {
    if (!place.factor || (all.factor && *all.factor <= *place.factor)) continue;
    all.factor = place.factor;
    all.coarse = too_coarse(place, verticals);
  }
  return found;
}

std::optional<Liquefaction> find_liquefaction(const Evidence& e) {
  return e.of(look_for_liquefaction).liquefaction;
}

std::string find_why_no_liquefaction(const Evidence& e) {
  return e.of(look_for_liquefaction).why_not;
}

const LiquefiedPlace* worst_place(const Liquefaction& all) {
  for (const LiquefiedPlace& place : all.places)
    if (place.factor && place.factor == all.factor) return &place;
  return nullptr;
}

std::string told_place(const LiquefiedPlace& place) {
  return "region '" + place.region + "'" + (place.side.empty() ? "" : " on the side of the " + place.side) + " at " +
         place_text(place.at) + ", " + with_unit(place.below, "m") + " below the surface, at " +
         significant(place.time) + " s";
}

/// Warnings momentary_liquefaction: pressure lifts the ground somewhere at some time; liquefaction_cells: cells under
/// the surface are too large for its gradient; liquefaction_open: a limit cannot be checked.
NumberedWarnings liquefaction_warnings(const Evidence& e, const Summary& summary) {
  const auto& limit = e.scene.limits.liquefaction;
  if (!limit) return {};
  if (!summary.liquefaction)
    return {{"liquefaction_open", 0., *limit, "1", "limits.liquefaction is not checked: " + summary.why_no_liquefaction,
             "see why, or leave that limit out"}};
  NumberedWarnings list;
  for (const LiquefiedPlace& place : summary.liquefaction->places)
    if (place.factor && *place.factor < 1.)
      list.push_back({"momentary_liquefaction", *place.factor, 1., "1",
                      "in " + told_place(place) + ", the pore pressure exceeds that on the surface above by " +
                          with_unit(place.pressure, "Pa") + ", and the effective stress at rest is " +
                          with_unit(place.stress, "Pa") + ": no stress is left down to " + with_unit(place.depth, "m"),
                      "put a filter or armour on it (initial.surcharge), or a more permeable layer"});
  if (const Liquefaction& all = *summary.liquefaction; !all.coarse.empty())
    list.push_back({"liquefaction_cells", *all.factor, *limit, "1",
                    "the factor against liquefaction is too large by an unknown part: " + all.coarse,
                    "make the cells under the surface smaller until the factor stays: mesh.refine = 1"});
  return list;
}

/// Whether a wave beside a caisson presses on its walls alone: then its trough over the ground, which lifts that most,
/// is not in the scene.
bool lacks_wave(const Scene& scene, const Summary& summary) {
  if (!summary.response || is_shaken(scene)) return false;
  const auto is_on_caisson = [&](const std::string& name) {
    return std::any_of(summary.loads.begin(), summary.loads.end(), [&](const LoadOnCaisson& on) {
      return on.name == name && (on.force_x != 0. || on.force_y != 0.);
    });
  };
  return std::none_of(scene.loads.begin(), scene.loads.end(), [&](const auto& load) {
    return load.second.kind == LoadKind::pressure && load.second.factor != 0. && !is_on_caisson(load.first);
  });
}

Checks liquefaction_checks(const Scene& scene, const Summary& summary) {
  if (!scene.limits.liquefaction) return {};
  std::string how =
      "effective vertical stress at rest, of the weight above, over the largest excess of the pore pressure over that "
      "on "
      "the surface above (Zen and Yamazaki 1990)";
  const Liquefaction none, &all = summary.liquefaction ? *summary.liquefaction : none;
  const LiquefiedPlace* worst = worst_place(all);
  if (worst) how += "; in " + told_place(*worst);
  Check check = held_to(check_of(FailureMode::momentary_liquefaction, "momentary liquefaction", "", all.factor,
                                 "liquefaction.factor", how),
                        scene.limits, &Limits::liquefaction);
  if (worst) check.balance = Balance{worst->pressure, worst->stress, "Pa"};
  if (!summary.liquefaction) return {not_checked(check, summary.why_no_liquefaction)};
  if (!worst) return {not_checked(check, "no pore pressure exceeds that on the surface above it")};
  if (!all.coarse.empty())
    return {in_doubt(check, significant(*all.factor, 4) + " is too large by an unknown part: " + all.coarse)};
  if (!lacks_wave(scene, summary)) return {check};
  return {in_doubt(check, "it is " + significant(*all.factor, 4) +
                              " by the caisson's motion alone: no load presses on the sea or the bed, where the "
                              "wave's trough lifts the ground ([loads.NAME.wave] mound, or kind = \"train\")")};
}

OutputSchema<LiquefiedPlace> place_outputs() {
  using P = LiquefiedPlace;
  return OutputSchema<P>()
      .key("region", &P::region, "", "its name")
      .reason("side", &P::side, "of the caisson: `sea`, `harbour`; null without a caisson")
      .key("factor", &P::factor, "", "least `stress` over `pressure`; null where nothing presses upward")
      .key("pressure", &P::pressure, "Pa", "excess of the pore pressure over that on the surface above, there and then")
      .key("stress", &P::stress, "Pa", "effective vertical stress at rest there, of the weight above")
      .key("at[]", &P::at, "m", "where")
      .key("below", &P::below, "m", "depth of that below the surface")
      .key("time", &P::time, "s", "when")
      .key("depth", &P::depth, "m",
           "greatest depth below the surface at which no stress is left at some time; 0: nowhere")
      .key("depth_x", &P::depth_x, "m", "x of that; null where `depth` is 0")
      .key("depth_time", &P::depth_time, "s", "and when")
      .key("cell", &P::cell, "m", "height of the uppermost cell at `at`");
}

}  // namespace

Finding liquefaction_finding() {
  Finding f;
  const auto keys =
      OutputSchema<Liquefaction>()
          .key("factor", &Liquefaction::factor, "", "least of all places; null where nothing presses upward")
          .list("places[]", &Liquefaction::places, place_outputs(), "each region on each side of the caisson");
  f.keys
      .object("liquefaction", &Summary::liquefaction, keys,
              "[momentary liquefaction](liquefaction.md) of the ground beside the caisson, where `limits.liquefaction` "
              "asks for it; else null")
      .reason("why_no_liquefaction", &Summary::why_no_liquefaction,
              "why it was not found though asked for; null where it was");
  f.warnings = liquefaction_warnings;
  f.checks = liquefaction_checks;
  return f.part(&Summary::liquefaction, find_liquefaction)
      .part(&Summary::why_no_liquefaction, find_why_no_liquefaction);
}

}  // namespace upbead
