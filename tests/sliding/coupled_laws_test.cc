// Claim: the motion of a caisson that slips on soil that it sets in motion obeys its laws: friction only dissipates,
// and work is the sum of energies stored and taken; under a mirrored pulse it slips the other way; more force moves
// it farther; N' that the slip itself changes is right (compared with many small steps); finer samples change
// nothing; after random waves the caisson always comes to rest.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>

#include "lumped.h"
#include "lumped_breakwater.h"
#include "random_waves.h"
#include "sliding/coupled_slip.h"
#include "upbead/sliding/pulse.h"

namespace upbead::test {
namespace coupled_laws_test {

constexpr double mass = 6e5, weight = 3.2e6, friction = 0.6, shift = 30.;
const ElasticBase base{2e5, 6e8, 4e6};
constexpr double coupling = 5e8;
const History pulse{{0., 0.05, 0.12, 0.3, 0.35, 0.5}, {0., 8e6, 1e6, -6e6, 0., 0.}};

Eigen::RowVectorXd integral(const Eigen::RowVectorXd& y, double step) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(y.size());
  for (Eigen::Index n = 1; n < y.size(); ++n) sum[n] = sum[n - 1] + 0.5 * step * (y[n - 1] + y[n]);
  return sum;
}

TEST(CoupledLaws, WorkIsWhatIsStoredAndTaken) {
  const System system = block_on_wedge(mass, base, coupling);
  const SlipModel model = in_modes(system, friction, shift, {1, 2}, 0);
  const auto mismatch = [&](double step) {
    const int n = static_cast<int>(std::lround(1. / step)) + 1;
    const WaveSamples loads = samples(pulse, weight, step, n);
    CoupledHistory history;
    const CoupledSliding found = CoupledSlip(model, step).slide(loads, &history);
    EXPECT_GT(found.slip.slips.size(), 1u);
    Eigen::MatrixXd velocity(3, n);
    velocity << history.outputs, history.velocity;
    Eigen::MatrixXd position(3, n);
    for (int i = 0; i < 3; ++i) position.row(i) = integral(velocity.row(i), step);
    const double work = integral(loads.row(0).cwiseProduct(velocity.row(0)), step)[n - 1];
    const Eigen::RowVectorXd power = velocity.cwiseProduct(system.C * velocity).colwise().sum();
    const Eigen::VectorXd v = velocity.rightCols(1), q = position.rightCols(1);
    const double stored = 0.5 * (v.dot(system.M * v) + q.dot(system.K * q));
    EXPECT_GT(found.dissipated, 0.1 * work) << "friction is a good part of it";
    return std::abs(work - stored - integral(power, step)[n - 1] - found.dissipated) / work;
  };
  EXPECT_LT(mismatch(1e-3), 2e-3);
  EXPECT_LT(mismatch(1e-4), 2e-5) << "the account's own integrals are of order step^2";
}

/// Moreau's time stepping: N' at the start of the step; friction either stops s' or acts with its limit.
double slip_in_small_steps(const System& system, const History& force, double step, double end) {
  const Eigen::MatrixXd M = system.M, inverse = M.inverse(), C = system.C, K = system.K;
  const auto n = static_cast<int>(end / step);
  const WaveSamples loads = samples(force, weight, step, n);
  Eigen::Vector3d q = Eigen::Vector3d::Zero(), v = q, a = q;
  for (int i = 0; i < n; ++i) {
    const double normal = weight - (K.row(1) * q + C.row(1) * v)(0) - (base.mass * a[1]);
    const Eigen::Vector3d free = v + step * inverse * (Eigen::Vector3d(loads(0, i), 0., 0.) - C * v - K * q);
    const double limit = friction * std::max(normal, 0.);
    const double F = std::min(std::max(free[2] / (step * inverse(2, 2)), -limit), limit);
    const Eigen::Vector3d next = free - step * F * inverse.col(2);
    a = (next - v) / step;
    v = next;
    q += step * v;
  }
  return q[2];
}

TEST(CoupledLaws, NormalForceThatTheSlipChanges) {
  const System system = block_on_wedge(mass, base, coupling);
  const double step = 1e-3;
  const WaveSamples loads = samples(pulse, weight, step, 1001);
  const double found = CoupledSlip(in_modes(system, friction, shift, {}, 0), step).slide(loads).slip.residual;
  const double coarse = slip_in_small_steps(system, pulse, 4e-6, 1.),
               fine = slip_in_small_steps(system, pulse, 2e-6, 1.);
  EXPECT_NEAR(2. * fine - coarse, found, 1e-4 * std::abs(found));
  const double without = CoupledSlip(in_modes(system, friction, shift), step).slide(loads).slip.residual;
  EXPECT_GT(std::abs(without - found), 0.05 * std::abs(found)) << "it matters here";
}

TEST(CoupledLaws, MirrorsWithTheForce) {
  const double step = 1e-3;
  History mirrored = pulse;
  for (double& value : mirrored.value) value = -value;
  const auto slide = [&](const System& system, const History& force, int normal) {
    return CoupledSlip(in_modes(system, friction, shift, {}, normal), step)
        .slide(samples(force, weight, step, 1001))
        .slip;
  };
  const System flat = block_on_base(mass, base);
  EXPECT_EQ(slide(flat, pulse, -1).residual, -slide(flat, mirrored, -1).residual);
  const Sliding a = slide(block_on_wedge(mass, base, coupling), pulse, 0),
                b = slide(block_on_wedge(mass, base, -coupling), mirrored, 0);
  ASSERT_EQ(a.slips.size(), b.slips.size());
  EXPECT_NEAR(a.residual, -b.residual, 1e-12 * a.path);
  EXPECT_NEAR(a.path, b.path, 1e-12 * a.path);
  EXPECT_GT(a.slips.size(), 1u);
}

TEST(CoupledLaws, LiftsWhereTheNormalForceIsGone) {
  // N' falls to -1/4 of its value for a while: then only P acts on the block.
  const double step = 1e-3, m = 6e5, R = friction * weight;
  const CoupledSlip slip(in_modes(block_on_rock(m), friction, shift), step);
  WaveSamples loads(2, 1001);
  loads.row(0).setConstant(0.5 * R);
  loads.row(1).setConstant(weight);
  loads.row(1).segment(100, 100).setConstant(-0.25 * weight);
  loads(1, 100) = loads(1, 199) = 0.;
  const CoupledSliding found = slip.slide(loads);
  EXPECT_NEAR(found.lifted_time, 0.099, 1e-12);
  EXPECT_EQ(found.least_normal, -0.25 * weight);
  ASSERT_EQ(found.slip.slips.size(), 1u);
  EXPECT_NEAR(found.dissipated, 0.5 * R * found.slip.residual, 2e-3 * found.dissipated) << "which P has done";
}

/// So no number of the law is one of N/m.
TEST(CoupledLaws, ABillionthOfAllForcesMovesItABillionth) {
  const double step = 1e-3;
  const CoupledSlip slip(in_modes(block_on_base(mass, base), friction, shift), step);
  WaveSamples loads = samples(pulse, weight, step, 1001);
  loads.row(1).segment(100, 100).setConstant(-0.25 * weight);  // it lifts, and lands again
  const CoupledSliding whole = slip.slide(loads), small = slip.slide(1e-9 * loads);
  ASSERT_EQ(whole.slip.slips.size(), small.slip.slips.size());
  EXPECT_GT(whole.slip.slips.size(), 1u);
  EXPECT_GT(whole.lifted_time, 0.09);
  EXPECT_NEAR(small.lifted_time, whole.lifted_time, 1e-12);
  EXPECT_NEAR(1e9 * small.slip.residual, whole.slip.residual, 1e-9 * whole.slip.path);
  EXPECT_NEAR(1e9 * small.slip.path, whole.slip.path, 1e-9 * whole.slip.path);
}

TEST(CoupledLaws, FrictionMayTakeWhatRoundOffAdds) {
  CoupledSliding s;
  s.available = -2.;  // J/m, of which one is uncertain
  s.uncertain = 1.;
  s.dissipated = -1. + 5e-7;
  EXPECT_EQ(why_no_distance(s), "");
  s.dissipated = -1. + 5e-6;
  EXPECT_NE(why_no_distance(s), "");
}

TEST(CoupledLaws, MoreForceMovesItFarther) {
  const LumpedBreakwater breakwater;
  const double step = 2e-3;
  const CoupledSlip slip(breakwater.model(0.6), step);
  std::vector<double> residual, largest;
  for (double peak = 3e6; peak < 9e6; peak *= 1.02) {
    const Sliding found = slip.slide(samples(history({peak, 0.2}), breakwater.weight, step, 1001)).slip;
    residual.push_back(found.residual);
    largest.push_back(found.largest);
  }
  ASSERT_GE(residual.size(), 47u);
  EXPECT_EQ(largest.front(), 0.);
  EXPECT_GT(largest.back(), 0.02);
  for (std::size_t i = 1; i < residual.size(); ++i) {
    EXPECT_GE(largest[i], largest[i - 1]);
    EXPECT_GE(residual[i], residual[i - 1] - 5e-4 * residual.back());
  }
}

TEST(CoupledLaws, FinerSamplesChangeNothing) {
  const LumpedBreakwater breakwater;
  const SlipModel model = breakwater.model(0.6);
  RandomWaves waves(3);
  int slid = 0;
  for (int i = 0; i < 40; ++i) {
    const History force = waves.next(2e-3);
    const auto slide = [&](double step) {
      return CoupledSlip(model, step)
          .slide(samples(force, breakwater.weight, step, static_cast<int>(std::lround(1.2 / step)) + 1))
          .slip;
    };
    const Sliding coarse = slide(2e-3), fine = slide(1e-3);
    EXPECT_NEAR(coarse.residual, fine.residual, 0.01 * fine.path + 1e-7) << i;
    slid += fine.path > 1e-4 ? 1 : 0;
  }
  EXPECT_GT(slid, 10);
}

TEST(CoupledLaws, RandomWavesLoseEnergyAndRest) {
  const LumpedBreakwater breakwater;
  const double step = 2e-3;
  RandomWaves waves(1);
  int slid = 0, lifted = 0;
  for (const double mu : {0.3, 0.6, 1., 1.5}) {
    const CoupledSlip slip(breakwater.model(mu), step);
    for (int i = 0; i < 500; ++i) {
      WaveSamples loads = samples(waves.next(step), breakwater.weight, step, 801);
      if (i % 2 == 1) loads.row(1) -= 0.5 * loads.row(0).cwiseMax(0.);  // an uplift that may exceed the weight
      const CoupledSliding found = slip.slide(loads);
      ASSERT_TRUE(std::isfinite(found.slip.residual));
      EXPECT_GE(found.dissipated, 0.);
      EXPECT_EQ(found.n_passed_over, 0);
      slid += found.slip.path > 0. ? 1 : 0;
      lifted += found.lifted_time > 0. ? 1 : 0;
    }
  }
  EXPECT_GT(slid, 300);
  EXPECT_GT(lifted, 20);
}

}  // namespace coupled_laws_test
}  // namespace upbead::test
