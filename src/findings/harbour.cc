// Still water that stands at two levels, in front of a caisson and behind it.
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/run_end.h"
#include "base/text.h"
#include "fem/compile.h"
#include "fem/outline.h"
#include "findings/topics.h"
#include "response/shear_response.h"

namespace upbead {

namespace {

constexpr double same_level = 1e-3;     // m
constexpr double small_push = 0.02;     // of mu W'
constexpr double same_push = 0.05;      // of the push, by which a load that stands for it may differ
constexpr double usual_friction = 0.6;  // of concrete on rubble, where the case gives none

/// Top of the waters on one side of the caisson; -infinity without any.
double level_beside(const Simulation& simulation, double side) {
  const double middle = simulation.compiled()->caisson->bottom_centre[0];
  double level = -infinity;
  for (const auto& [name, extent] : outline_of(*simulation.given_mesh()).surfaces) {
    const auto region = simulation.scene().regions.find(name);
    if (region == simulation.scene().regions.end() || region->second.kind != RegionKind::water) continue;
    if (side * (0.5 * (extent.left + extent.right) - middle) > 0.) level = std::max(level, extent.highest);
  }
  return level;
}

double resistance_of(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (scene.sliding) return scene.sliding->friction * scene.sliding->submerged_weight;
  return usual_friction * simulation.compiled()->caisson->body.mass * scene.gravity;
}

/// Whether a level of the case is that of the water in the mesh, where there is some.
bool is_level_of(const Simulation& simulation, double level, double side) {
  const double meshed = level_beside(simulation, side);
  return !std::isfinite(meshed) || std::abs(meshed - level) <= same_level;
}

/// Whether the case gives both levels, and they are those of the mesh.
bool is_counted(const Simulation& simulation) {
  const auto& initial = simulation.scene().initial;
  return initial && initial->harbour_level && is_level_of(simulation, *initial->water_level, -1.) &&
         is_level_of(simulation, *initial->harbour_level, 1.);
}

HarbourSummary given_harbour(const Simulation& simulation) {
  const InitialState& initial = *simulation.scene().initial;
  const StillWater still = still_water(simulation.scene(), *simulation.compiled()->caisson);
  return {*initial.water_level, *initial.harbour_level, still.push, still.weight, true};
}

/// None without a caisson between two waters of the mesh, where both stand at one level, or where the loads end with
/// that push: then it is one of them.
std::optional<HarbourSummary> harbour_of(const Simulation& simulation) {
  if (!simulation.compiled()->caisson) return std::nullopt;
  if (is_counted(simulation)) return given_harbour(simulation);
  HarbourSummary h{level_beside(simulation, -1.), level_beside(simulation, 1.), 0., 0., false};
  if (!std::isfinite(h.front) || !std::isfinite(h.back) || std::abs(h.front - h.back) <= same_level)
    return std::nullopt;
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double unit_weight = simulation.scene().fluid.density * simulation.scene().gravity;
  const double front = std::max(h.front - caisson.bottom_centre[1], 0.),
               back = std::max(h.back - caisson.bottom_centre[1], 0.);
  h.push = 0.5 * unit_weight * (front * front - back * back);
  // a load that ends with that push is the push
  const double held =
      until_end(force_on_caisson(*simulation.compiled()), simulation.scene().time.end, simulation.scene().time.end);
  if (std::abs(held - h.push) <= same_push * std::abs(h.push)) return std::nullopt;
  // the pressure under the base falls in a straight line from one level to the other; W' has that of the higher one
  h.weight_gained = 0.5 * unit_weight * caisson.bottom_width * std::abs(front - back);
  return h;
}

/// Warning harbour_level: a level of [initial] is not that of the water in the mesh, so that the push and W' are of
/// other water than the one that swings. It voids the verdict.
NumberedWarnings level_warnings(const Simulation& simulation) {
  const auto& initial = simulation.scene().initial;
  if (!simulation.compiled()->caisson || !initial || !initial->water_level) return {};
  for (const double side : {-1., 1.}) {
    const bool behind = side > 0.;
    if (behind && !initial->harbour_level) continue;
    const double given = behind ? *initial->harbour_level : *initial->water_level;
    if (is_level_of(simulation, given, side)) continue;
    const std::string key = behind ? "harbour_level" : "water_level";
    return {{"harbour_level", given, level_beside(simulation, side), "m",
             "[initial] " + key + " = " + significant(given, 6) + " m, but the water " +
                 (behind ? "behind" : "in front of") +
                 " the caisson is meshed up to y = " + significant(level_beside(simulation, side), 6) +
                 " m: what stands still and what swings are not the same water, and no verdict may be drawn",
             "give the level of the mesh, or mesh the water up to that level", true}};
  }
  return {};
}

/// Warning harbour_level: the scene has one level at rest, and the push by the other is in the checks of friction
/// alone. It voids the verdict unless it is small against mu W'.
NumberedWarnings harbour_warnings(const Simulation& simulation, const std::optional<double>&) {
  if (NumberedWarnings wrong = level_warnings(simulation); !wrong.empty()) return wrong;
  const std::optional<HarbourSummary> h = harbour_of(simulation);
  if (!h || h->counted) return {};
  const double share = std::abs(h->push) / resistance_of(simulation);
  const bool large = share > small_push;
  return {{"harbour_level", h->back, h->front, "m",
           "still water stands at y = " + significant(h->front, 5) + " m in front of the caisson and at " +
               significant(h->back, 5) + " m behind it: it pushes the caisson by " +
               with_unit(std::abs(h->push), "N/m") + (h->push > 0. ? " landward, " : " seaward, ") + percent(share) +
               " of mu W', and W' is up to " + with_unit(h->weight_gained, "N/m") +
               " more than at the higher level. That push is in the checks of the force against friction alone: "
               "stresses at "
               "rest, pressures, margins against overturning and sliding distances are those of one level, " +
               (large ? "so that no verdict may be drawn from them" : "which at so small a push changes little"),
           std::string(large ? "" : "look whether a margin is so small that this push matters, or ") +
               "give both levels, [initial] water_level = " + significant(h->front, 6) +
               " and harbour_level = " + significant(h->back, 6) + ": all numbers then have them",
           large}};
}

std::optional<HarbourSummary> find_harbour(const Evidence& e) {
  return harbour_of(e.simulation);
}

OutputSchema<HarbourSummary> harbour_outputs() {
  using H = HarbourSummary;
  return OutputSchema<H>()
      .key("front", &H::front, "m", "height y of still water in front of the caisson")
      .key("back", &H::back, "m", "and behind it")
      .key("push", &H::push, "N/m", "of both on the caisson at rest, landward")
      .key("weight_gained", &H::weight_gained, "N/m",
           "by which W' is more than that in water as high as the sea; where it is not `counted`, as the higher level, "
           "and "
           "in no other number")
      .key("counted", &H::counted, "",
           "whether stresses at rest, W', margins, pressures and S have both levels, by `initial.harbour_level`");
}

}  // namespace

Finding harbour_finding() {
  Finding f;
  f.keys.object("harbour", &Summary::harbour, harbour_outputs(),
                "still water at two levels ([harbour_level](warnings.md)); null where it has one");
  f.of_scene = harbour_warnings;
  return f.part(&Summary::harbour, find_harbour);
}

}  // namespace upbead
