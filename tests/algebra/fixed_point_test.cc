#include "algebra/fixed_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "upbead/algebra/petsc_session.h"

namespace upbead {
namespace fixed_point_test {

class FixedPointTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { static const PetscSession petsc; }  // MPI starts once in a process
};

/// q_i = b_i - slope_i q_i + bend tanh(q_i): slopes from 0 to 0.9, as of soil that loses up to nine tenths of
/// stiffness.
void bend(const Vector& q, Vector& value) {
  const int n = static_cast<int>(q.size());
  for (int i = 0; i < n; ++i) value[i] = 1. + 0.01 * i + 0.9 * i / n * q[i] - 0.2 * std::tanh(q[i]);
}

TEST_F(FixedPointTest, FindsWhatTheMapLeavesInFewerStepsThanThePlainIteration) {
  const int n = 50;
  FixedPoint solver(n, bend);
  for (const double tolerance : {1e-6, 1e-10}) {
    Vector q = Vector::Zero(n), value(n);
    const FixedPointReport report = solver.solve(q, tolerance);
    EXPECT_TRUE(report.converged);
    bend(q, value);
    EXPECT_LE((value - q).norm(), tolerance);
    EXPECT_NEAR(report.residual, (value - q).norm(), 1e-3 * tolerance);
    Vector plain = Vector::Zero(n);
    int steps = 0;
    for (; steps < 1000; ++steps) {
      bend(plain, value);
      if ((value - plain).norm() <= tolerance) break;
      plain = value;
    }
    EXPECT_LT(2 * report.evaluations, steps);
  }
}

TEST_F(FixedPointTest, OneEvaluationTellsThatNothingIsToBeDone) {
  FixedPoint solver(3, [](const Vector&, Vector& value) { value.setZero(3); });
  Vector q = Vector::Zero(3);
  const FixedPointReport report = solver.solve(q, 1e-12);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.evaluations, 1);
  EXPECT_EQ(q.norm(), 0.);
}

TEST_F(FixedPointTest, TellsWhereItGaveUp) {
  FixedPoint away(
      1, [](const Vector& q, Vector& value) { value = q.array() + 1.; }, 7);
  Vector q = Vector::Zero(1);
  const FixedPointReport report = away.solve(q, 1e-6);
  EXPECT_FALSE(report.converged);
  EXPECT_LE(report.evaluations, 8);
  FixedPoint infinite(1, [](const Vector&, Vector& value) { value[0] = std::numeric_limits<double>::quiet_NaN(); });
  q.setZero();
  EXPECT_FALSE(infinite.solve(q, 1e-6).converged);
}

TEST_F(FixedPointTest, PassesOnWhatTheMapThrows) {
  FixedPoint solver(1, [](const Vector& q, Vector& value) {
    if (std::abs(q[0]) > 0.5) throw std::runtime_error("too far");
    value = 1.5 * q.array() + 1.;
  });
  Vector q = Vector::Zero(1);
  EXPECT_THROW(solver.solve(q, 1e-12), std::runtime_error);
}

}  // namespace fixed_point_test
}  // namespace upbead
