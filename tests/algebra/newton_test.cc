// Claims: Newton's method finds the root of functions with unsymmetric derivatives in few steps, and by its line
// search also where full steps diverge; it reports when it gives up; a matrix keeps its pattern from solution to
// solution.

#include "algebra/newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "upbead/algebra/petsc_session.h"

namespace upbead {
namespace newton_test {

class NewtonTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { static const PetscSession petsc; }  // MPI starts once in a process
};

/// A chain in which each unknown depends on the next more strongly than the next depends on it: an unsymmetric
/// matrix.
struct Chain {
  int n;
  Vector at;
  SparseMatrix pattern() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
      for (int j = std::max(0, i - 1); j <= std::min(n - 1, i + 1); ++j) entries.emplace_back(i, j, 1.);
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
  void residual(const Vector& x, Vector& r) {
    at = x;
    r.resize(n);
    for (int i = 0; i < n; ++i)
      r[i] = 2. * x[i] + std::pow(x[i], 3) - (i > 0 ? 0.2 * x[i - 1] : 0.) - (i + 1 < n ? 0.9 * x[i + 1] : 0.) - 1.;
  }
  void derivative(Eigen::Ref<Vector> values) const {
    int k = 0;
    for (int i = 0; i < n; ++i)
      for (int j = std::max(0, i - 1); j <= std::min(n - 1, i + 1); ++j)
        values[k++] = j == i ? 2. + 3. * at[i] * at[i] : j < i ? -0.2 : -0.9;
  }
};

TEST_F(NewtonTest, ConvergesQuadraticallyWithAnUnsymmetricDerivative) {
  Chain chain{40, {}};
  Newton newton(
      chain.pattern(), [&](const Vector& x, Vector& r) { chain.residual(x, r); },
      [&](Eigen::Ref<Vector> values) { chain.derivative(values); });
  for (const double start : {0., 1.}) {
    Vector x = Vector::Constant(40, start), r;
    const NewtonReport report = newton.solve(x, 1e-12);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.iterations, 6);
    chain.residual(x, r);
    EXPECT_LE(r.norm(), 1e-12);
    EXPECT_NEAR(report.residual, r.norm(), 1e-13);
  }
}

struct Scalar {
  SparseMatrix one = SparseMatrix(Eigen::MatrixXd::Ones(1, 1).sparseView());
  double x = 0.;
};

TEST_F(NewtonTest, CutsStepsThatLeapAndTellsWhereThereIsNoRoot) {
  Scalar s;
  Newton arctangent(
      s.one,
      [&](const Vector& x, Vector& r) {
        s.x = x[0];
        r = Vector::Constant(1, std::atan(x[0]));
      },
      [&](Eigen::Ref<Vector> values) { values[0] = 1. / (1. + s.x * s.x); });
  Vector x = Vector::Constant(1, 10.);  // full steps diverge from |x| = 1.4 on
  EXPECT_TRUE(arctangent.solve(x, 1e-12).converged);
  EXPECT_NEAR(x[0], 0., 1e-12);

  Newton none(
      s.one,
      [&](const Vector& at, Vector& r) {
        s.x = at[0];
        r = Vector::Constant(1, 1. + at[0] * at[0]);
      },
      [&](Eigen::Ref<Vector> values) { values[0] = 2. * s.x; }, 12);
  Vector y = Vector::Constant(1, 3.);
  const NewtonReport report = none.solve(y, 1e-12);
  EXPECT_FALSE(report.converged);
  EXPECT_GE(report.residual, 1.);
}

/// r = x + 9 max(x - 1, 0) - 5 with a derivative ten thousand times too large up to x = 1: the root 1.4.
TEST_F(NewtonTest, ByThePotentialStepsAreAlsoLengthened) {
  Scalar s;
  const auto residual = [&](const Vector& x, Vector& r) {
    s.x = x[0];
    r = Vector::Constant(1, x[0] + 9. * std::max(x[0] - 1., 0.) - 5.);
  };
  const auto derivative = [&](Eigen::Ref<Vector> values) { values[0] = s.x < 1. ? 1e4 : 10.; };
  Vector lengthened = Vector::Zero(1), cut = lengthened;
  EXPECT_TRUE(Newton(s.one, residual, derivative, 30, StepLength::by_potential).solve(lengthened, 1e-12).converged);
  EXPECT_NEAR(lengthened[0], 1.4, 1e-12);
  EXPECT_FALSE(Newton(s.one, residual, derivative, 30, StepLength::by_residual).solve(cut, 1e-12).converged);
}

TEST_F(NewtonTest, SingularAndNotFiniteAreNoConvergenceAndThrowsComeThrough) {
  Scalar s;
  Newton singular(
      s.one, [](const Vector&, Vector& r) { r = Vector::Constant(1, 1.); },
      [](Eigen::Ref<Vector> values) { values[0] = 0.; });
  Vector x = Vector::Zero(1);
  EXPECT_FALSE(singular.solve(x, 1e-12).converged);
  Newton infinite(
      s.one, [](const Vector&, Vector& r) { r = Vector::Constant(1, HUGE_VAL); },
      [](Eigen::Ref<Vector> values) { values[0] = 1.; });
  EXPECT_FALSE(infinite.solve(x, 1e-12).converged);
  Newton broken(
      s.one, [](const Vector&, Vector&) { throw std::runtime_error("broken"); },
      [](Eigen::Ref<Vector> values) { values[0] = 1.; });
  EXPECT_THROW(broken.solve(x, 1e-12), std::runtime_error);
}

}  // namespace newton_test
}  // namespace upbead
