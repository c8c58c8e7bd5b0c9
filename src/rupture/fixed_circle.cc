#include "rupture/fixed_circle.h"

#include <cmath>

namespace upbead {

std::optional<FamilyCircle> family_circle(const GroundSection& section, const GroundLoads& loads,
                                          const SlipCircle& circle, SlipsTo slips, double from, double to, int n) {
  GroundLoads still;
  still.surcharge = loads.surcharge;
  const double side = slips == SlipsTo::right ? 1. : -1.;
  const Slices slices = slices_of(section, still, arc_of(circle, slips), from, to, n);
  if (slices.why != NoFactor::none) return std::nullopt;
  FamilyCircle found{circle.x, circle.y, circle.radius, from, to, slips == SlipsTo::right, 0., {}};
  for (const Slice& s : slices.list) {
    found.slices.push_back({s.x, s.width, s.base.sine, s.base.cosine, s.cohesion, s.friction, s.vertical});
    found.weight_moment += side * s.vertical * (circle.x - s.x) * s.width;
  }
  return found;
}

std::vector<SliceReading> readings_of(const GroundSection& section, const FamilyCircle& circle) {
  const double side = circle.landward ? 1. : -1.;
  std::vector<SliceReading> list;
  for (const FamilySlice& s : circle.slices) {
    const double top = section.surface(s.x).value_or(circle.y);
    const double left = section.surface(s.x - 0.5 * s.width).value_or(top);
    const double right = section.surface(s.x + 0.5 * s.width).value_or(top);
    const double away = circle.x - s.x, bottom = circle.y - std::sqrt(circle.radius * circle.radius - away * away);
    // dF = p (dy/dx, -1) dx, as in slices.cc; its moment about the centre
    list.push_back({{s.x, top}, {s.x, bottom}, side * (s.width * away + (right - left) * (circle.y - top))});
  }
  return list;
}

}  // namespace upbead
