#include "run/sliding/uplift.h"

#include <algorithm>
#include <utility>

#include "response/shear_response.h"
#include "response/slip_law.h"

namespace upbead {

namespace {

bool pushes_seaward_alone(const TimeFunction& P, double end) {
  return upbead::pushes_seaward_alone(extremum(P, 0., end, 1).value, extremum(P, 0., end, -1).value);
}

/// U follows P by `lag` while P is landward, or where it never is, while it is seaward; with the course held, U stays
/// at its peak after the peak of P.
TimeFunction follow_force(const UpliftChoice& uplift, const TimeFunction& force, double end) {
  const TimeFunction P = pushes_seaward_alone(force, end) ? scaled(force, -1.) : force;
  const Extremum largest = extremum(P, 0., end, 1);
  if (largest.value <= 0.) return {};
  const double lag = uplift.lag, peak = *uplift.peak, over = largest.time + lag;
  const bool held = uplift.course == UpliftCourse::held;
  std::vector<double> kinks{lag}, samples;
  for (const double t : P.kinks())
    if (t > 0. && (!held || t < largest.time)) kinks.push_back(t + lag);
  if (held && largest.time > 0.) kinks.push_back(over);
  for (const double t : P.samples())
    if (t >= 0. && (!held || t < largest.time)) samples.push_back(t + lag);
  std::vector<TimeFunction::Piece> pieces{[](double) { return 0.; }};
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    const double inside = (i + 1 < kinks.size() ? 0.5 * (kinks[i] + kinks[i + 1]) : kinks[i] + 1.) - lag;
    if (held && inside >= largest.time)
      pieces.emplace_back([peak](double) { return peak; });
    else
      pieces.emplace_back([=](double t) { return peak * (std::max(P(t - lag, inside), 0.) / largest.value); });
  }
  return {kinks, pieces, samples};
}

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

TimeFunction prescribed_uplift(const UpliftChoice& uplift, const TimeFunction& P, double end) {
  return uplift.peak ? follow_force(uplift, P, end) : uplift.history;
}

std::vector<UpliftLoad> uplift_loads(const Simulation& simulation, const std::vector<double>& position,
                                     const std::vector<double>& length) {
  const auto& sliding = simulation.scene().sliding;
  if (!simulation.compiled()->caisson || !sliding || !sliding->uplift ||
      sliding->uplift->kind != UpliftKind::prescribed)
    return {};
  const UpliftChoice& uplift = *sliding->uplift;
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double B = caisson.bottom_width, from = caisson.bottom_centre[0] - 0.5 * B, to = from + B;
  std::vector<UpliftPart> parts = uplift.parts;
  if (parts.empty()) {
    const bool triangle = uplift.distribution == UpliftDistribution::triangle;  // p_u = 2 U/B, Goda (2000)
    const TimeFunction P = force_on_caisson(*simulation.compiled());
    const double end = simulation.scene().time.end;
    double wet = (triangle ? 2. : 1.) / B, dry = triangle ? 0. : 1. / B;  // at the edge under the wave, at the other
    if (pushes_seaward_alone(P, end)) std::swap(wet, dry);
    parts.push_back({{{from, wet}, {to, dry}}, prescribed_uplift(uplift, P, end)});
  }
  std::vector<UpliftLoad> loads;
  for (const UpliftPart& part : parts) loads.push_back(load_of(part, from, to, position, length));
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
