#include "run/sliding/uplift.h"

#include <algorithm>
#include <utility>

#include "response/shear_response.h"

namespace upbead {

namespace {

/// Integrals of one part, from `from` to `to` (m): exact, as shape times x is a parabola between the points.
struct ShapeIntegral {
  double force = 0., moment_about_zero = 0.;
};

double at(const std::vector<std::array<double, 2>>& shape, double x) {
  for (std::size_t i = 1; i < shape.size(); ++i)
    if (shape[i - 1][0] <= x && x <= shape[i][0]) {
      const double part = (x - shape[i - 1][0]) / (shape[i][0] - shape[i - 1][0]);
      return (1. - part) * shape[i - 1][1] + part * shape[i][1];
    }
  return 0.;
}

ShapeIntegral integrate(const std::vector<std::array<double, 2>>& shape, double from, double to) {
  ShapeIntegral sum;
  for (std::size_t i = 1; i < shape.size(); ++i) {
    const double a = std::max(shape[i - 1][0], from), b = std::min(shape[i][0], to), middle = 0.5 * (a + b);
    if (!(a < b)) continue;
    const auto [x0, s0] = shape[i - 1];
    const double slope = (shape[i][1] - s0) / (shape[i][0] - x0);
    const auto value = [x0 = x0, s0 = s0, slope](double x) { return s0 + slope * (x - x0); };
    sum.force += (b - a) * value(middle);
    sum.moment_about_zero += (b - a) / 6. * (a * value(a) + 4. * middle * value(middle) + b * value(b));
  }
  return sum;
}

/// The force of a node is its length times the pressure there; the sum is made equal to that of the whole shape.
UpliftLoad load_of(const UpliftPart& part, double from, double to, const std::vector<double>& position,
                   const std::vector<double>& length) {
  const ShapeIntegral whole = integrate(part.shape, from, to);
  UpliftLoad load{Vector::Zero(static_cast<Eigen::Index>(position.size())), whole.force,
                  0.5 * (from + to) * whole.force - whole.moment_about_zero, part.pressure};
  for (std::size_t i = 0; i < position.size(); ++i)
    load.node[static_cast<Eigen::Index>(i)] = length[i] * at(part.shape, position[i]);
  if (const double sum = load.node.sum(); sum > 0.) load.node *= whole.force / sum;
  return load;
}

}  // namespace

UpliftLoad uplift_of_peak(const Simulation& simulation, const std::vector<double>& position,
                          const std::vector<double>& length, bool seaward, const TimeFunction& U) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double B = caisson.bottom_width, from = caisson.bottom_centre[0] - 0.5 * B, to = from + B;
  const bool triangle = simulation.scene().sliding->uplift->distribution == UpliftDistribution::triangle;
  double wet = (triangle ? 2. : 1.) / B, dry = triangle ? 0. : 1. / B;  // at the edge under the wave, at the other
  if (seaward) std::swap(wet, dry);
  return load_of({{{from, wet}, {to, dry}}, U}, from, to, position, length);
}

std::vector<UpliftLoad> uplift_loads(const Simulation& simulation, const std::vector<double>& position,
                                     const std::vector<double>& length) {
  const auto& sliding = simulation.scene().sliding;
  if (!simulation.compiled()->caisson || !sliding || !sliding->uplift ||
      sliding->uplift->kind != UpliftKind::prescribed)
    return {};
  const UpliftChoice& uplift = *sliding->uplift;
  if (uplift.parts.empty()) {
    const TimeFunction P = force_on_caisson(*simulation.compiled());
    const double end = simulation.scene().time.end;
    return {
        uplift_of_peak(simulation, position, length, pushes_seaward_alone(P, end), prescribed_uplift(uplift, P, end))};
  }
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double B = caisson.bottom_width, from = caisson.bottom_centre[0] - 0.5 * B, to = from + B;
  std::vector<UpliftLoad> loads;
  for (const UpliftPart& part : uplift.parts) loads.push_back(load_of(part, from, to, position, length));
  return loads;
}

std::array<TimeFunction, 2> pressures_at_feet(const Simulation& simulation) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  std::array<TimeFunction, 2> pressures;
  for (const auto& [name, load] : simulation.scene().loads) {
    if (load.boundary.empty() || load.factor == 0. || is_motion(load.kind)) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      dealii::Point<dim> foot = caisson.bottom_centre;
      foot[0] += (side == 0 ? -0.5 : 0.5) * caisson.bottom_width;
      if (const double at_foot = pressure_at_foot(*simulation.space(), load, foot); at_foot != 0.)
        pressures[side] = sum(pressures[side], scaled(load.history, at_foot));
    }
  }
  return pressures;
}

}  // namespace upbead
