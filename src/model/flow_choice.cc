#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "model/choices.h"

namespace upbead {

namespace {

// Measured on the shipped prototype, so that peak F_T moves by less than 0.1 %: docs/skipping.md.
constexpr double largest_X_of_darcy = 0.15;
constexpr double least_theta_of_drained = 1.;

/// Twice the least distance of two kinks, 0 where f jumps at one.
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

/// c_v / (omega l^2), l the longest way of the water out of the region (m): how far pressure drains in the time of the
/// fastest change, with c_v = (k / rho_f g) (lambda + 2 G); 0 where something keeps the pressure up.
double drainage(const Region& region, const Surroundings& at, const Scene& scene, double omega) {
  if (!at.has_open_side || at.has_load || at.touches_water) return 0.;
  const Material m = material(region, scene.fluid, scene.gravity);
  const double l = std::max(at.height, 0.5 * at.width);
  return m.b > 0. && omega > 0. && l > 0. ? m.constrained_modulus() / m.b / (omega * l * l) : 0.;
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
  const double omega = bandwidth(scene), k = region.hydraulic_conductivity.value_or(0.);
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
  if (choice.flow != Flow::darcy || at.has_probe || !scene.regions.count(caisson_name)) return choice;
  const double theta = drainage(region, at, scene, omega);
  if (theta >= least_theta_of_drained) {
    choice.flow = Flow::drained;
    choice.reason = "c_v/(omega l^2) = " + significant(theta) + " >= " + significant(least_theta_of_drained) +
                    ": its water is out before the loads have changed";
  }
  return choice;
}

}  // namespace upbead
