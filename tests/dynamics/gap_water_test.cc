// Claims: under a block that lifts slowly, the sea in the gap brings about the state of a cracked base by statics (full
// pressure along the gap, from its end in a straight line to zero at the other edge, effective stress a triangle:
// Ebeling et al. 2000, ERDC/ITL TR-00-1), whatever pressed on the closed base; it mirrors with the force; the balance
// of energy closes; while nothing opens, and where the sea has no pressure, all is as without it, to the last bit.
#include "dynamics/gap_water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact_systems.h"

namespace gap_water_test {

using namespace upbead;
using namespace upbead::test;

constexpr double width = 18., weight = 3.2e6, height = 8.;

/// A block on n equal parts of a base, each with a node in its middle; no friction is reached.
BlockOnNodes block_of(int n) {
  BlockOnNodes block;
  block.position.clear();
  for (int i = 0; i < n; ++i) block.position.push_back(width * ((i + 0.5) / n - 0.5));
  block.kx = 1.2e9 / n;
  block.ky = 2.4e9 / n;
  block.cx = 1e7 / n;
  block.cy = 2e7 / n;
  block.weight = weight;
  block.friction = 5.;
  return block;
}

/// Its system with gaps that are open to water of these pressures, and with the triangle of an uplift that is
/// `closed_pressure` at the seaward edge.
System with_water(System system, const TimeFunction& seaward, const TimeFunction& landward,
                  const TimeFunction& closed_pressure = {}) {
  Interface& interface = *system.interface;
  const int n = interface.n_nodes();
  interface.length.assign(static_cast<std::size_t>(n), width / n);
  const auto water = std::make_shared<GapWater>();
  water->foot = {seaward, landward};
  Vector triangle(n);
  for (int i = 0; i < n; ++i) triangle[i] = width / n * (0.5 - interface.position[static_cast<std::size_t>(i)] / width);
  water->closed = {{triangle, closed_pressure}};
  Vector load = Vector::Zero(system.size());
  load.tail(n) = triangle;
  system.loads.push_back({"uplift", load, closed_pressure, -1});
  interface.gap = water;
  return system;
}

struct Statics {
  double open = 0., normal = 0., heel = 0.;  ///< m, N/m, Pa
};

/// The equilibrium of a cracked base under the moment M about its middle, by bisection.
Statics cracked_base(double M, double p) {
  const auto excess = [&](double a) {  // of 3 (B/2 - e) over the width in contact that belongs to a gap of that length
    const double c = width - a, N = weight - p * a - 0.5 * p * c;
    const double moment = M + p * a * 0.5 * (width - a) + 0.5 * p * c * (0.5 * width - a - c / 3.);
    return 3. * (0.5 * width - moment / N) - c;
  };
  double low = 0., high = width;
  for (double a = 0.; a < width; a += 0.01)
    if (excess(a) > 0.) {
      high = a;
      break;
    }
  for (int i = 0; i < 100; ++i) (excess(0.5 * (low + high)) > 0. ? high : low) = 0.5 * (low + high);
  const double c = width - low, N = weight - p * low - 0.5 * p * c;
  return {low, N, 2. * N / c};
}

/// Rises in 20 s and stays.
TimeFunction slowly(double value) {
  return piecewise_linear({0., 20., 1e9}, {0., value, value});
}

void compare_with_statics(double P, double p, double closed_pressure) {
  SCOPED_TRACE(std::to_string(P) + " N/m, " + std::to_string(p) + " Pa, " + std::to_string(closed_pressure) + " Pa");
  const int n = 360;
  BlockOnNodes block = block_of(n);
  block.arm = height;
  System system = with_water(block.system(slowly(P)), slowly(p), {}, slowly(closed_pressure));
  system.M = SparseMatrix(system.M.rows(), system.M.cols());
  const ContactMarch march = march_contact(system, 40., 0.25);
  const Statics exact = cracked_base(2. * height * P, std::max(p, closed_pressure));
  const Vector opening = march.states.back().x.tail(n), N = march.forces.back().normal;
  EXPECT_NEAR((opening.array() > 0.).count() * width / n, exact.open, 2. * width / n);
  EXPECT_NEAR(N.sum(), exact.normal, 2e-3 * exact.normal);
  EXPECT_NEAR(N[n - 1] * n / width, exact.heel, 1e-2 * exact.heel);
  const Vector &last = march.states.back().x, &before = march.states[march.states.size() - 2].x;
  EXPECT_LT((last - before).norm(), 1e-9 * last.norm()) << "it has come to rest";
  EXPECT_LT(march.mismatch(), 1e-12);
}

TEST(GapWater, LiftsABlockAsStaticsOfACrackedBaseSay) {
  EXPECT_NEAR(cracked_base(14.4e6, 0.).open, width - 3. * (0.5 * width - 14.4e6 / weight), 1e-6);  // no water
  EXPECT_GT(cracked_base(14.4e6, 3e4).open, cracked_base(14.4e6, 0.).open + 1.);
  compare_with_statics(9e5, 0., 0.);
  compare_with_statics(9e5, 3e4, 0.);
  compare_with_statics(9e5, 3e4, 3e4);
  compare_with_statics(9e5, 3e4, 1.5e4);
  compare_with_statics(7e5, 6e4, 6e4);
  compare_with_statics(7e5, 3e4, 6e4);  // an uplift that is held has the larger pressure
}

ContactMarch hit(double P, double seaward, double landward, double step, double arm = 4.) {
  BlockOnNodes block = block_of(20);
  block.arm = arm;
  block.friction = 0.6;
  const System system = block.system(triangle(P, 0.3));
  return march_contact(with_water(system, triangle(seaward, 0.6), triangle(landward, 0.6)), 3., step);
}

double highest(const ContactMarch& march) {
  double most = 0.;
  for (const State& state : march.states) most = std::max(most, state.x.tail(20).maxCoeff());
  return most;
}

TEST(GapWater, MirrorsWithTheForceAndKeepsTheBalance) {
  const ContactMarch a = hit(3e6, 6e4, 0., 2e-3), b = hit(-3e6, 0., 6e4, 2e-3), dry = hit(3e6, 0., 0., 2e-3);
  const Vector to_land = a.states.back().x.segment(3, 20), to_sea = b.states.back().x.segment(3, 20);
  EXPECT_LT((to_land + to_sea.reverse()).norm(), 1e-9 * to_land.norm());
  EXPECT_LT(a.mismatch(), 1e-12);
  EXPECT_LT(b.mismatch(), 1e-12);
  EXPECT_GT(highest(a), 1.05 * highest(dry));
  EXPECT_GT(to_land.mean(), dry.states.back().x.segment(3, 20).mean());
}

/// The gap is that of the step before: the difference that steps make falls with them.
TEST(GapWater, IsTheSameWithShorterSteps) {
  const double coarse = highest(hit(3e6, 6e4, 0., 4e-3)), middle = highest(hit(3e6, 6e4, 0., 2e-3)),
               fine = highest(hit(3e6, 6e4, 0., 5e-4));
  EXPECT_LT(std::abs(coarse / fine - 1.), 2e-2);
  EXPECT_LT(std::abs(middle / fine - 1.), 1e-2);
}

TEST(GapWater, IsNothingWhereNothingOpensOrHasAPressure) {
  BlockOnNodes block = block_of(20);
  block.arm = 4.;
  block.friction = 0.6;
  for (const double P : {3e5, 3e6}) {
    const TimeFunction sea = P > 1e6 ? TimeFunction() : triangle(6e4, 0.6);
    const System system = block.system(triangle(P, 0.3));
    const ContactMarch with = march_contact(with_water(system, sea, {}), 2., 2e-3),
                       without = march_contact(system, 2., 2e-3);
    ASSERT_EQ(with.report.open_steps > 0, P > 1e6);
    for (std::size_t i = 0; i < with.states.size(); ++i) ASSERT_EQ(with.states[i].x, without.states[i].x) << i;
  }
}

}  // namespace gap_water_test
