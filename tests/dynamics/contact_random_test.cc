// Claims: no step of a thousand random blocks under random forces fails; none breaks the law, penetrates or gains
// energy from friction. Ground of any stiffness with and without mass, mu up to 1.5, nodes without normal force at
// rest, forces that lift the block off.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact_systems.h"

namespace contact_random_test {

using namespace upbead;
using namespace upbead::test;

class RandomBlock {
 public:
  explicit RandomBlock(unsigned seed) : generator_(seed) {
    const int n = 1 + static_cast<int>(8. * uniform());
    const double stiffness = std::pow(10., 8.5 + 2. * uniform());
    block.position.clear();
    for (int i = 0; i < n; ++i) block.position.push_back(n == 1 ? 0. : -9. + 18. * i / (n - 1));
    block.kx = stiffness / n;
    block.ky = (0.5 + 2. * uniform()) * stiffness / n;
    block.link = uniform() * stiffness / n;
    block.cx = 2e7 * uniform() / n;
    block.cy = 3e7 * uniform() / n;
    block.node_mass = uniform() < 0.2 ? 0. : 3e5 * uniform() / n;
    block.arm = -8. + 12. * uniform();
    block.height = 4. + 6. * uniform();
    block.friction = 1.5 * uniform();
    if (uniform() < 0.3) share_weight(n);
  }
  System system() {
    const double size = block.weight * 3. * uniform();
    return block.system(noise(size), noise(0.5 * size));
  }

  BlockOnNodes block;

 private:
  double uniform() { return std::uniform_real_distribution<double>(0., 1.)(generator_); }
  void share_weight(int n) {
    Vector share = Vector::NullaryExpr(n, [&] { return uniform() < 0.2 ? 0. : uniform(); });
    share[0] += 1e-3;
    share *= block.weight / share.sum();
    block.normal_force.assign(share.data(), share.data() + n);
  }
  TimeFunction noise(double size) {
    std::vector<double> time, value;
    for (int i = 0; i < 6; ++i) {
      time.push_back(0.1 * i);
      value.push_back(i == 0 || i == 5 ? 0. : size * (2. * uniform() - 1.));
    }
    return piecewise_linear(time, value);
  }

  std::mt19937 generator_;
};

/// Largest violation of the law by forces and motions, over the largest force.
double violation(const State& state, const InterfaceForces& forces, double friction, double weight) {
  const Eigen::Index n = forces.shear.size();
  double worst = 0., scale = weight;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double T = forces.shear[i], N = forces.normal[i];
    const double rate = state.v[3 + i], opening = state.x[3 + n + i];
    scale = std::max({scale, std::abs(T), std::abs(N)});
    worst = std::max({worst, -N, std::abs(T) - friction * std::max(N, 0.)});
    if (opening < 0.) return 1e300;
    if (opening > 0.) worst = std::max(worst, std::abs(N));
    if (rate != 0.) worst = std::max(worst, std::abs(T - friction * N * (rate > 0. ? 1. : -1.)));
  }
  return worst / scale;
}

// 1e-9: the tolerance of forces is 1e-10. Bound of friction: round-off of energies that reach 1e3 times the work at
// the end.
TEST(FrictionalContact, ObeysTheLawInAThousandRandomCases) {
  int impacts = 0, slips = 0, fallbacks = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    RandomBlock random(seed);
    const ContactMarch result = march_contact(random.system(), 0.6, 0.01);
    double worst = 0.;
    for (std::size_t i = 0; i < result.states.size(); ++i)
      worst =
          std::max(worst, violation(result.states[i], result.forces[i], random.block.friction, random.block.weight));
    EXPECT_LT(worst, 1e-9) << seed;
    EXPECT_LT(result.mismatch(), 1e-10) << seed;
    EXPECT_GT(result.least_friction_step(), -1e-12) << seed;
    impacts += result.report.impacts;
    slips += result.report.slip_steps;
    fallbacks += result.report.fallbacks;
  }
  EXPECT_GT(impacts, 1000);
  EXPECT_GT(slips, 10000);
  EXPECT_LE(fallbacks, 5) << "the active set finds nearly all by itself; measured: 0";
}

}  // namespace contact_random_test
