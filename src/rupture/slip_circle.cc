#include "rupture/slip_circle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace upbead {

std::function<std::optional<BasePoint>(double x)> arc_of(const SlipCircle& circle, SlipsTo slips) {
  const double side = slips == SlipsTo::right ? 1. : -1.;
  return [circle, side](double x) -> std::optional<BasePoint> {
    const double R = circle.radius, away = circle.x - x, below = R * R - away * away;
    if (!(below > 0.)) return std::nullopt;
    return BasePoint{circle.y - std::sqrt(below), side * away / R, std::sqrt(below) / R};
  };
}

bool may_slip(double shear, double moment, SlipsTo slips) {
  const double side = slips == SlipsTo::right ? 1. : -1.;
  return !(side * shear < 0. && side * moment < 0.);
}

FigureSafety circle_safety(const GroundSection& section, const GroundLoads& loads, const SlipCircle& circle,
                           SlipsTo slips, double from, double to, int n_slices) {
  const double side = slips == SlipsTo::right ? 1. : -1., R = circle.radius;
  const Slices slices = slices_of(section, loads, arc_of(circle, slips), from, to, n_slices);
  double moment = loads.strip ? loads.strip->horizontal * (circle.y - loads.strip->level) : 0.;
  for (const Slice& s : slices.list)
    moment += (s.vertical * (circle.x - s.x) + circle.y * s.horizontal - s.horizontal_moment) * s.width;
  FigureSafety found = safety_of(slices, side * moment / R, [](const Slice&) { return 1.; });
  found.from = from;
  found.to = to;
  return found;
}

FigureSafety circle_safety(const GroundSection& section, const GroundLoads& loads, const SlipCircle& circle,
                           SlipsTo slips, int n_slices) {
  // the arc's height below the surface, negative above it
  const auto depth = [&](double x) {
    const double away = x - circle.x, below = std::max(circle.radius * circle.radius - away * away, 0.);
    const std::optional<double> surface = section.surface(x);
    return surface ? *surface - circle.y + std::sqrt(below) : -1.;
  };
  const auto crossing = [&](double outside, double inside) {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (outside + inside);
      (depth(middle) > 0. ? inside : outside) = middle;
    }
    return inside;
  };
  constexpr int n = 1000;
  const double step = 2. * circle.radius / n, first = circle.x - circle.radius;
  std::array<double, 2> longest{0., 0.};
  for (int i = 0; i <= n; ++i) {
    if (depth(first + i * step) <= 0.) continue;
    const int begin = i;
    while (i < n && depth(first + (i + 1) * step) > 0.) ++i;
    if (begin == 0 || i == n) continue;  // the circle overhangs
    const double from = crossing(first + (begin - 1) * step, first + begin * step);
    const double to = crossing(first + (i + 1) * step, first + i * step);
    if (to - from > longest[1] - longest[0]) longest = {from, to};
  }
  if (!(longest[1] > longest[0])) return {std::numeric_limits<double>::infinity(), NoFactor::outside, 0., 1., 0., 0.};
  return circle_safety(section, loads, circle, slips, longest[0], longest[1], n_slices);
}

}  // namespace upbead
