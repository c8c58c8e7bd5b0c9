#include "model/choices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "base/text.h"
#include "upbead/model/scene.h"

namespace upbead {

namespace {

// Measured on the shipped prototype, so that peak F_T moves by less than 0.1 %: docs/skipping.md.
constexpr double largest_X_of_darcy = 0.15;
constexpr double least_theta_of_drained = 1.;

/// Twice the least distance of two kinks, 0 where f jumps at a kink.
double duration_of_kinks(const TimeFunction& f) {
  const std::vector<double>& kinks = f.kinks();
  double least = infinity, largest = 0., largest_jump = 0.;
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    const double before = i == 0 ? kinks[i] - 1. : 0.5 * (kinks[i - 1] + kinks[i]);
    const double left = f(kinks[i], before), right = f(kinks[i]);
    largest = std::max({largest, std::abs(left), std::abs(right)});
    largest_jump = std::max(largest_jump, std::abs(right - left));
    if (i > 0) least = std::min(least, kinks[i] - kinks[i - 1]);
  }
  constexpr double round_off = 1e-9;
  return largest_jump > round_off * largest ? 0. : 2. * least;
}

}  // namespace

double shortest_duration(const Scene& scene) {
  double shortest = infinity;
  for (const auto& [name, load] : scene.loads)
    shortest = std::min(shortest, load.duration ? *load.duration : duration_of_kinks(load.history));
  return shortest;
}

namespace {

/// c_v / (omega l^2): how far pressure drains in the time of the fastest change, c_v = (k / rho_f g) (lambda + 2 G), l
/// the longest path of the water out of the region (m); 0 where something keeps the pressure up.
double drainage(const Region& region, const Surroundings& at, const Scene& scene, double omega) {
  if (!at.has_open_side || at.has_load || at.touches_water) return 0.;
  const Material m = material(region, scene.fluid, scene.gravity);
  const double l = std::max(at.height, 0.5 * at.width);
  const double slower = std::min(1., m.vertical_flow);  // k of the direction in which less flows, over k_x
  return m.b > 0. && omega > 0. && l > 0. ? slower * m.constrained_modulus() / m.b / (omega * l * l) : 0.;
}

/// Darcy or inertial, by X.
void choose_by_inertia(double omega, FlowChoice& choice) {
  const bool fast = choice.X > largest_X_of_darcy;
  choice.flow = fast ? Flow::inertial : Flow::darcy;
  const std::string X = "X = k omega/(g n) = " + significant(choice.X);
  choice.reason = X + (fast ? " > " : " <= ") + significant(largest_X_of_darcy) + " at omega = " + significant(omega) +
                  " rad/s, the end of the loads' spectrum: " +
                  (fast ? "the water's own inertia counts" : "drag outweighs the water's own inertia");
}

}  // namespace

FlowChoice choose_flow(const Region& region, const Surroundings& at, const Scene& scene) {
  FlowChoice choice;
  const double omega = bandwidth(scene), k = std::max(1., region.conductivity_ratio) *
                                             conductivity(region, scene.fluid, scene.gravity).value_or(0.);
  choice.X = k > 0. && omega > 0. ? k * omega / (scene.gravity * region.porosity.value_or(1.)) : 0.;
  if (region.flow != Flow::automatic) {
    choice.flow = region.flow;
    choice.reason = "stated in the case";
    return choice;
  }
  if (!scene.time.inertia) {
    choice.reason = "quasi-static (time.inertia = false): no inertia to move";
  } else if (omega == 0.) {
    choice.reason = "no load: drag alone holds the water";
  } else if (std::isinf(omega)) {
    choice.flow = Flow::inertial;
    choice.reason = "a load jumps: the water's own inertia counts";
  } else {
    choose_by_inertia(omega, choice);
  }
  if (choice.flow != Flow::darcy || at.has_probe || region.forchheimer || !scene.regions.count(caisson_name))
    return choice;
  const double theta = drainage(region, at, scene, omega);
  if (theta >= least_theta_of_drained) {
    choice.flow = Flow::drained;
    choice.reason = "c_v/(omega l^2) = " + significant(theta) + " >= " + significant(least_theta_of_drained) +
                    ": its water is out before the loads have changed";
  }
  return choice;
}

namespace {

// Measured on the shipped prototype, so that peak F_T moves by less than 0.1 %: docs/skipping.md.
constexpr double largest_of_incompressible = 0.2;  ///< omega h / c
constexpr double largest_of_rigid = 0.01;  ///< G of the stiffest neighbour over its own, times max(1, (height/width)^2)
constexpr double largest_crossing = 0.3;   ///< omega height / V_s

/// Frequency of the loads (rad/s); infinite where one jumps, 0 where none has a duration.
double frequency(const Scene& scene) {
  const double duration = shortest_duration(scene);
  return duration > 0. ? pi / duration : infinity;
}

/// The largest shear modulus of the regions that a region touches (Pa).
double stiffest_neighbour(const Surroundings& at, const Scene& scene) {
  double G = 0.;
  for (const std::string& name : at.touches) {
    const Region& other = scene.regions.at(name);
    if (other.kind == RegionKind::rigid) return infinity;
    G = std::max(G, material(other, scene.fluid, scene.gravity).G);
  }
  return G;
}

}  // namespace

CompressibilityChoice choose_compressibility(const Region& region, const Surroundings& at, const Scene& scene) {
  using C = Compressibility;
  if (region.compressibility != C::automatic) return {region.compressibility, "stated in the case"};
  const double c = std::sqrt(scene.fluid.bulk_modulus / scene.fluid.density), omega = frequency(scene);
  const double ratio = std::isinf(c) ? 0. : omega * at.height / c;
  const std::string text = "omega h/c = " + significant(ratio), limit = significant(largest_of_incompressible);
  if (!at.has_open_side) return {C::compressible, "it has no open level at which it could give way"};
  if (ratio > largest_of_incompressible) return {C::compressible, text + " > " + limit + ": sound takes its time"};
  return {C::incompressible, text + " <= " + limit + ": sound crosses its depth at once"};
}

DeformationChoice choose_deformation(const Region& region, const Surroundings& at, const Scene& scene) {
  using D = Deformation;
  if (region.deformation != D::automatic) return {region.deformation, "stated in the case"};
  if (at.is_held) return {D::elastic, "one of its sides is held"};
  if (at.has_probe) return {D::elastic, "it is looked into, by a probe or by fields"};
  const Material m = material(region, scene.fluid, scene.gravity);
  const double slenderness = at.width > 0. ? at.height / at.width : infinity;
  const double stiffness = stiffest_neighbour(at, scene) / m.G * std::max(1., slenderness * slenderness);
  const double crossing = frequency(scene) * at.height / std::sqrt(m.G / m.rho);
  const std::string text = "softness " + significant(stiffness) + ", omega h/V_s = " + significant(crossing);
  const std::string limits = significant(largest_of_rigid) + " and " + significant(largest_crossing);
  if (stiffness > largest_of_rigid || crossing > largest_crossing) return {D::elastic, text + ": above " + limits};
  return {D::rigid, text + " <= " + limits + ": it moves as a rigid body"};
}

namespace {

/// Integral of |f| and total variation of f' over [0, end]; f is taken as linear between many points of each smooth
/// piece.
struct Shape {
  double integral = 0., variation = 0.;
};

std::vector<double> points_of(const TimeFunction& f, double end) {
  std::vector<double> corners{0., end}, points;
  for (const double kink : f.kinks())
    if (kink > 0. && kink < end) corners.push_back(kink);
  std::sort(corners.begin(), corners.end());
  constexpr int parts = 64;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    for (int j = 0; j < parts; ++j) points.push_back(corners[i] + (corners[i + 1] - corners[i]) * j / parts);
  for (const double sample : f.samples())
    if (sample > 0. && sample < end) points.push_back(sample);
  points.push_back(end);
  std::sort(points.begin(), points.end());
  return points;
}

Shape shape_of(const TimeFunction& f, double end) {
  const std::vector<double> t = points_of(f, end);
  Shape shape;
  double slope = 0.;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double step = t[i + 1] - t[i], inside = t[i] + 0.5 * step;
    if (step <= 1e-12 * end) continue;
    const double a = f(t[i], inside), b = f(t[i + 1], inside);
    shape.integral += 0.5 * (std::abs(a) + std::abs(b)) * step;
    shape.variation += std::abs((b - a) / step - slope);
    slope = (b - a) / step;
  }
  return shape;
}

}  // namespace

double bandwidth(const Scene& scene) {
  if (shortest_duration(scene) == 0.) return std::numeric_limits<double>::infinity();
  constexpr double least_share = 0.01;
  double largest = 0.;
  for (const auto& [name, load] : scene.loads) {
    const Shape shape = shape_of(load.history, scene.time.end);
    if (shape.integral > 0.) largest = std::max(largest, std::sqrt(shape.variation / (least_share * shape.integral)));
  }
  return largest;
}

}  // namespace upbead
