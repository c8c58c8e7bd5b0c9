// Claim: with gravity waves at its level, water in a closed basin has standing waves of the exact frequencies.
// Source: omega^2 = g k tanh(k h), k = n pi / L (linear waves; Lamb, Hydrodynamics, art. 228 and 257), against the
// eigenvalues of the water's own M and K.
// Limit: 0.1 % of the frequency.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "reservoir.h"

namespace upbead::test {
namespace surface_waves_test {

/// Squares of the circular frequencies, ascending, without the first: a uniform rise costs no force. M has entries
/// only at the level, so K phi = omega^2 M phi is inverted: M phi = mu (K + s M) phi.
std::vector<double> squares_of_frequencies(const System& water, double shift, int count) {
  const Eigen::MatrixXd M = -Eigen::MatrixXd(water.M), K = -Eigen::MatrixXd(water.K);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(M, K + shift * M, Eigen::EigenvaluesOnly);
  const Eigen::VectorXd& mu = modes.eigenvalues();  // ascending
  std::vector<double> found;
  for (int n = 1; n <= count; ++n) found.push_back(1. / mu[mu.size() - 1 - n] - shift);
  return found;
}

TEST(SurfaceWaves, StandInAClosedBasinAtTheExactFrequencies) {
  Record record("water_waves");
  const double gravity = Scene().gravity, pi = std::acos(-1.);
  for (const auto& [depth, length] : {std::pair{15., 30.}, std::pair{2., 20.}}) {
    ReservoirShape shape;
    shape.depth = depth;
    shape.length = length;
    shape.cells = depth > 10. ? 5 : 2;
    shape.degree = 3;
    shape.level = PressureCondition::surface_waves;
    const Reservoir basin(shape, {1025., std::numeric_limits<double>::infinity()});
    const auto found = squares_of_frequencies(basin.water(triangle(1., 1.)), gravity / depth, 5);
    for (int n = 1; n <= 5; ++n) {
      const double k = n * pi / length, exact = std::sqrt(gravity * k * std::tanh(k * depth));
      record.at_most("basin of " + std::to_string(std::lround(length)) + " m, " + std::to_string(std::lround(depth)) +
                         " m deep: frequency of mode " + std::to_string(n),
                     std::abs(std::sqrt(found[static_cast<std::size_t>(n - 1)]) / exact - 1.), 1e-3);
    }
  }
}

}  // namespace surface_waves_test
}  // namespace upbead::test
