#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

#include "upbead/base/text.h"
#include "upbead/model/choices.h"

namespace upbead {

namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_X_of_darcy = 0.05;

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

FlowChoice choose_flow(const Region& region, const Scene& scene) {
  FlowChoice choice;
  const double duration = shortest_duration(scene);
  const double k = region.hydraulic_conductivity.value_or(0.), n = region.porosity.value_or(1.);
  const double omega = duration > 0. ? pi / duration : infinity;
  choice.X = k > 0. ? k * omega / (scene.gravity * n) : 0.;
  const bool fast = choice.X > largest_X_of_darcy;
  choice.flow = fast && scene.time.inertia ? Flow::inertial : Flow::darcy;
  const std::string X = "X = k omega/(g n) = " + significant(choice.X), limit = significant(largest_X_of_darcy);
  if (region.flow != Flow::automatic) {
    choice.flow = region.flow;
    choice.reason = "stated in the case";
  } else if (!scene.time.inertia) {
    choice.reason = "quasi-static (time.inertia = false): no inertia to move";
  } else if (duration == infinity) {
    choice.reason = "no load with a duration: drag alone holds the water";
  } else if (duration == 0.) {
    choice.reason = "a load jumps, so " + X + ": the water's own inertia counts";
  } else {
    choice.reason = X + (fast ? " > " : " <= ") + limit + " for loads of " + significant(duration) +
                    " s: " + (fast ? "the water's own inertia counts" : "drag outweighs the water's own inertia");
  }
  return choice;
}

}  // namespace upbead
