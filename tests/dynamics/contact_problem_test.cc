// Claims: the solution of ContactProblem obeys Coulomb's law and that of contact at every node, for any stiffness
// that couples the nodes; it does not depend on the first guess where it is unique; a node that sticks, or is closed,
// moves by exactly zero; mirrored data give the mirrored solution; sweeps find the solution where the active set
// repeats itself.
// Bounds 1e-9 of the largest force: tolerances are 1e-10, and D has condition numbers up to 1e3.
#include "../../src/dynamics/contact_problem.h"

#include <gtest/gtest.h>

#include <random>

namespace contact_problem_test {

using namespace upbead;
using namespace upbead::detail;

struct Case {
  Eigen::MatrixXd D;
  ContactPoint point;  ///< its motion is not zero
  double friction = 0.;

  Eigen::Index n() const { return D.rows() / 2; }
  double scale() const {
    return std::max(point.forces.shear.cwiseAbs().maxCoeff(), point.forces.normal.cwiseAbs().maxCoeff());
  }
  std::vector<ContactState> all(ContactState contact) const {
    return std::vector<ContactState>(static_cast<std::size_t>(n()), contact);
  }
};

/// Nodes of different stiffness, coupled by at most `coupling` times that stiffness.
Case random_case(int n, double coupling, double friction, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1., 1.);
  const auto vector = [&](Eigen::Index size) { return Vector::NullaryExpr(size, [&] { return entry(generator); }); };
  const Eigen::MatrixXd R = Eigen::MatrixXd::NullaryExpr(2 * n, 2 * n, [&] { return entry(generator); });
  Case result;
  result.D = coupling * R * R.transpose() / (2 * n) + Eigen::MatrixXd::Identity(2 * n, 2 * n);
  const Vector unit = (2. * vector(2 * n)).array().exp();
  result.D = unit.asDiagonal() * result.D * unit.asDiagonal();
  result.friction = friction;
  result.point = {vector(2 * n), {3. * vector(n), vector(n).array() + 0.5}};
  return result;
}

Case mirrored(Case c) {
  const Eigen::Index n = c.n();
  c.D.topRightCorner(n, n) *= -1.;
  c.D.bottomLeftCorner(n, n) *= -1.;
  c.point.motion.head(n) *= -1.;
  c.point.forces.shear *= -1.;
  return c;
}

ContactPoint solve(const Case& c, std::vector<ContactState> guess, int* fallbacks = nullptr) {
  ContactProblem problem(c.D, c.friction);
  const ContactPoint found = problem.solve(c.point, 0., guess);
  if (fallbacks != nullptr) *fallbacks += problem.n_fallbacks();
  return found;
}

/// Largest violation of the law, and of the line on which forces lie, over the largest force.
double violation(const Case& c, const ContactPoint& found) {
  const Eigen::Index n = c.n();
  Vector force(2 * n);
  force << -c.point.forces.shear, c.point.forces.normal;
  force += c.D * (found.motion - c.point.motion);
  double worst = std::max((found.forces.shear + force.head(n)).cwiseAbs().maxCoeff(),
                          (found.forces.normal - force.tail(n)).cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double T = -force[i], N = force[n + i], slip = found.motion[i], opening = found.motion[n + i];
    worst = std::max({worst, -N, std::abs(T) - c.friction * std::max(N, 0.)});
    if (opening < 0.) return 1e300;
    if (opening > 0.) worst = std::max(worst, std::abs(N));
    if (slip != 0.) worst = std::max(worst, std::abs(T - c.friction * N * (slip > 0. ? 1. : -1.)));
  }
  return worst / c.scale();
}

TEST(ContactProblem, OfOneNodeByHand) {
  Case c{Eigen::Vector2d(4., 2.).asDiagonal(), {Vector::Zero(2), {Vector(1), Vector(1)}}, 0.5};
  const auto at = [&](double T, double N) {
    c.point.forces.shear << T;
    c.point.forces.normal << N;
    return solve(c, c.all(ContactState::stick));
  };
  EXPECT_EQ(at(0.4, 1.).motion, Vector::Zero(2));
  EXPECT_EQ(at(0.4, 1.).forces.shear[0], 0.4);
  EXPECT_DOUBLE_EQ(at(0.9, 1.).motion[0], 0.1) << "T falls by 4 q to 1/2";
  EXPECT_DOUBLE_EQ(at(-0.9, 1.).motion[0], -0.1);
  EXPECT_EQ(at(0.9, 1.).motion[1], 0.);
  EXPECT_DOUBLE_EQ(at(0.8, -1.).motion[1], 0.5);
  EXPECT_DOUBLE_EQ(at(0.8, -1.).motion[0], 0.2) << "an open node carries no shear either";
  EXPECT_EQ(at(0., 0.).motion, Vector::Zero(2)) << "nothing presses, nothing pulls";
  EXPECT_DOUBLE_EQ(at(0.8, 0.).motion[0], 0.2) << "without normal force there is no friction";
}

// A first guess that is right up to round-off is kept, but no node penetrates or slips against its shear force.
TEST(ContactProblem, LeavesNoRoundOffInWhatTheLawForbids) {
  ContactProblem problem(Eigen::Vector2d(4., 2.).asDiagonal().toDenseMatrix(), 0.5);
  ContactPoint point{Vector::Zero(2), {Vector::Constant(1, 0.), Vector::Constant(1, 1e-13)}};
  std::vector<ContactState> status{ContactState::open};
  EXPECT_EQ(problem.solve(point, 1., status).motion, Vector::Zero(2));
  EXPECT_EQ(status[0], ContactState::open);
  point.forces = {Vector::Constant(1, 0.5 - 1e-13), Vector::Constant(1, 1.)};
  status = {ContactState::slip_landward};
  EXPECT_EQ(problem.solve(point, 1., status).motion, Vector::Zero(2));
  EXPECT_EQ(status[0], ContactState::slip_landward);
}

// mu up to 1.5 with couplings up to the stiffness itself.
TEST(ContactProblem, ObeysTheLawWhateverTheGuess) {
  for (const int n : {1, 2, 5, 20})
    for (unsigned seed = 0; seed < 100; ++seed)
      for (const double friction : {0., 0.3, 0.6, 1.5}) {
        const Case c = random_case(n, 0.8, friction, seed);
        const ContactPoint cold = solve(c, c.all(ContactState::stick));
        EXPECT_LT(violation(c, cold), 1e-9) << n << " nodes, mu " << friction << ", seed " << seed;
        EXPECT_LT(violation(c, solve(c, c.all(ContactState::open))), 1e-9);
      }
}

TEST(ContactProblem, DoesNotDependOnTheGuessNorOnTheSide) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Case c = random_case(8, 0.5, 0.6, seed);
    const ContactPoint cold = solve(c, c.all(ContactState::stick));
    const double size = cold.motion.norm() + 1e-12;
    for (const ContactState guess : {ContactState::open, ContactState::slip_landward, ContactState::slip_seaward})
      EXPECT_LT((solve(c, c.all(guess)).motion - cold.motion).norm(), 1e-9 * size) << seed;
    const ContactPoint other = mirrored({c.D, cold, c.friction}).point,
                       mirror = solve(mirrored(c), c.all(ContactState::stick));
    EXPECT_LT((mirror.motion - other.motion).norm(), 1e-9 * size) << seed;
  }
}

// Every step of a march starts where the last one ended.
TEST(ContactProblem, StaysAtItsSolution) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Case c = random_case(8, 0.5, 0.6, seed);
    std::vector<ContactState> status = c.all(ContactState::stick);
    ContactProblem problem(c.D, c.friction);
    const ContactPoint found = problem.solve(c.point, 0., status);
    const std::vector<ContactState> before = status;
    const ContactPoint again = problem.solve(found, c.scale(), status);
    EXPECT_EQ(status, before);
    EXPECT_LT((again.motion - found.motion).norm(), 1e-12 * (1. + found.motion.norm()));
  }
}

// Nodes at the limit between two states: no normal force, or shear just at its bound.
TEST(ContactProblem, OfDegenerateForces) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Case c = random_case(6, 0.5, 0.6, seed);
    c.point.motion.setZero();
    c.point.forces.normal.head(2).setZero();
    c.point.forces.shear.head(1).setZero();
    c.point.forces.normal.tail(3) = c.point.forces.normal.tail(3).cwiseAbs();
    c.point.forces.shear.tail(2) = c.friction * c.point.forces.normal.tail(2);
    EXPECT_LT(violation(c, solve(c, c.all(ContactState::stick))), 1e-9) << seed;
  }
}

TEST(ContactProblem, FallsBackToSweepsWhereTheActiveSetRunsInCircles) {
  int fallbacks = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Case c = random_case(20, 3., 1., seed);
    EXPECT_LT(violation(c, solve(c, c.all(ContactState::stick), &fallbacks)), 1e-9) << seed;
  }
  EXPECT_GT(fallbacks, 0) << "else this tests nothing";
  RecordProperty("fallbacks", fallbacks);
}

// Sweeps alone converge, slowly, to the same solution.
TEST(ContactSweeps, ComeToTheSameStatuses) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Case c = random_case(5, 0.5, 0.6, seed);
    std::vector<ContactState> status = c.all(ContactState::stick);
    ContactProblem(c.D, c.friction).solve(c.point, 0., status);
    const Eigen::MatrixXd W = c.D.inverse();
    ContactSweeps sweeps(W, c.friction, c.point);
    for (int i = 0; i < 300; ++i) sweeps.sweep();
    EXPECT_EQ(sweeps.status(), status) << seed;
  }
}

TEST(ContactProblem, SaysWhetherStickingObeysTheLaw) {
  const auto holds = [](double T, double N) {
    return ContactProblem::holds({Vector::Constant(1, T), Vector::Constant(1, N)}, 0.5, 1.);
  };
  EXPECT_TRUE(holds(0.5, 1.));
  EXPECT_TRUE(holds(-0.5, 1.));
  EXPECT_FALSE(holds(0.5 + 1e-8, 1.));
  EXPECT_FALSE(holds(0., -1e-8));
  EXPECT_TRUE(holds(0., 0.));
}

}  // namespace contact_problem_test
