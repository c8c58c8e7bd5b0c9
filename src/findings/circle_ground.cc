#include "findings/circle_ground.h"

#include <algorithm>
#include <cmath>

#include "fem/compile.h"
#include "findings/topics.h"

namespace upbead {

namespace {

/// The weights of [initial.surcharge] over x, each between its ends on its curve.
std::function<double(double)> surcharge_of(const Simulation& simulation) {
  if (!simulation.scene().initial || simulation.scene().initial->surcharge.empty()) return {};
  struct Piece {
    double from, to, weight;
  };
  std::vector<Piece> pieces;
  const Mesh& mesh = *simulation.mesh();
  for (const auto& [name, s] : simulation.scene().initial->surcharge)
    for (const auto& face : mesh.triangulation.active_face_iterators()) {
      if (mesh.curve_of(face) != s.boundary) continue;
      const double a = face->vertex(0)[0], b = face->vertex(1)[0];
      const double from = std::max(std::min(a, b), s.from.value_or(-HUGE_VAL));
      const double to = std::min(std::max(a, b), s.to.value_or(HUGE_VAL));
      if (to > from) pieces.push_back({from, to, s.weight});
    }
  return [pieces = std::move(pieces)](double x) {
    double sum = 0.;
    for (const Piece& piece : pieces)
      if (x >= piece.from && x < piece.to) sum += piece.weight;
    return sum;
  };
}

constexpr double widths_beside = 4.;

}  // namespace

CircleGround::CircleGround(const Simulation& simulation)
    : section(ground_section(simulation)), surcharge(surcharge_of(simulation)) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double B = caisson.bottom_width;
  left = caisson.bottom_centre[0] - 0.5 * B;
  right = left + B;
  level = caisson.bottom_centre[1];
  from = std::max(section.left(), left - widths_beside * B);
  to = std::min(section.right(), right + widths_beside * B);
}

std::optional<GroundLoads> loads_of(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure) {
  GroundLoads loads;
  loads.strip = effective_strip(moment.force, moment.moment, moment.shear, ground.left, ground.right, ground.level);
  if (!loads.strip) return std::nullopt;
  loads.pressure = pressure;
  loads.surcharge = ground.surcharge;
  return loads;
}

CircleRange range_beside(const CircleGround& ground, const StripLoad& strip) {
  return {{ground.from, strip.from}, {strip.to, ground.to}};
}

bool may_slip(const BaseMoment& moment, SlipsTo slips) {
  const double side = slips == SlipsTo::right ? 1. : -1.;
  return !(side * moment.shear < 0. && side * moment.moment < 0.);
}

PointGrid grid_of(const CircleGround& ground) {
  double low = ground.level, high = ground.level;
  for (int i = 0; i <= 100; ++i)
    high = std::max(high, ground.section.surface(ground.from + (ground.to - ground.from) * i / 100.).value_or(low));
  const double B = ground.right - ground.left;
  low -= widths_beside * B;
  const auto points = [B](double length) { return 2 + static_cast<int>(40. * length / B); };
  return {{ground.from, ground.to}, {low, high}, {points(ground.to - ground.from), points(high - low)}};
}

std::string why_no_circles_in(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (!simulation.compiled()->caisson) return "there is no caisson";
  if (std::none_of(scene.regions.begin(), scene.regions.end(), [](const auto& r) { return r.second.strength; }))
    return "no region has a table strength";
  if (is_shaken(scene)) return "a motion shakes the ground, and slices have no inertia";
  return "";
}

}  // namespace upbead
