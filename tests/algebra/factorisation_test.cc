// Claims: L D L^T after equilibration solves a symmetric quasi-definite matrix whose entries span 1e-10 to 1e12 to
// round-off; eliminating cell-local blocks first changes nothing; the pivots' signs are those of the unknowns'
// definite blocks; what is singular is refused with a message.
// Source: Vanderbei, Symmetric quasi-definite matrices, SIAM J. Optim. 5 (1995) 100; Sylvester's law of inertia.
// Tolerances: 1e-13 of the equilibrated residual is 450 units of round-off, row by row.
#include "algebra/factorisation.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "upbead/base/error.h"

namespace factorisation_test {

using namespace upbead;

/// [H B'; B -G] on `n_cells` chained cells: unknowns of a cell are 4 "W" (block), 4 "u", 2 "phi"; u and phi also couple
/// to the next cell. H and G dominate their off-diagonals; scaled by D A D with D from 1e-5 to 1e6.
struct Problem {
  SparseMatrix A;
  std::vector<IndexRange> blocks;
  Vector scale;
  int n_negative;
};

Problem quasi_definite(int n_cells, bool scaled, bool empty_negative_diagonal = false, unsigned seed = 7) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1., 1.);
  const int n = 10 * n_cells, n_w = 4 * n_cells, n_u = 4 * n_cells;
  Problem p{SparseMatrix(n, n), {}, Vector::Ones(n), 2 * n_cells};
  std::vector<Eigen::Triplet<double>> triplets;
  const auto add = [&](int i, int j, double value) {
    triplets.emplace_back(i, j, value);
    if (i != j) triplets.emplace_back(j, i, value);
  };
  for (int c = 0; c < n_cells; ++c) {
    std::vector<int> w, u, phi;
    for (int i = 0; i < 4; ++i) w.push_back(4 * c + i);
    for (int i = 0; i < 8; ++i) u.push_back(n_w + (4 * c + i) % n_u);
    for (int i = 0; i < 4; ++i) phi.push_back(n_w + n_u + (2 * c + i) % (2 * n_cells));
    p.blocks.push_back({4 * c, 4 * c + 4});
    for (int i : w) add(i, i, 14.);
    for (int i : u) add(i, i, 14.);
    for (int i : phi) add(i, i, empty_negative_diagonal ? 0. : -3.);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) add(w[i], w[j], entry(random));
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < i; ++j) add(u[i], u[j], entry(random));
    for (int i : w)
      for (int j : u) add(i, j, entry(random));
    for (int j : phi) {
      for (int i : w) add(i, j, entry(random));
      for (int i : u) add(i, j, entry(random));
    }
  }
  p.A.setFromTriplets(triplets.begin(), triplets.end());
  if (!scaled) return p;
  for (int i = 0; i < n; ++i) p.scale[i] = i < n_w ? 1e2 : i < n_w + n_u ? 3e5 : 3e-6;
  for (int i = 0; i < n; ++i) p.scale[i] *= std::pow(10., 0.3 * entry(random));
  p.A = SparseMatrix(p.scale.asDiagonal() * p.A * p.scale.asDiagonal());
  return p;
}

/// |b - A x| row by row against |A||x| + |b|.
double residual(const SparseMatrix& A, const Vector& x, const Vector& b) {
  const Vector r = b - A * x, size = A.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs();
  return (r.array() / size.array()).abs().maxCoeff();
}

TEST(Factorisation, SolvesABadlyScaledMatrixToRoundOff) {
  const Problem p = quasi_definite(40, true);
  const Eigen::MatrixXd dense(p.A);
  ASSERT_GT(dense.cwiseAbs().maxCoeff(), 1e12);
  ASSERT_LT(dense.diagonal().cwiseAbs().minCoeff(), 1e-10);
  const Vector b = p.scale.cwiseProduct(Vector::LinSpaced(p.A.rows(), -1., 2.));
  for (const auto& blocks : {std::vector<IndexRange>{}, p.blocks})
    EXPECT_LT(residual(p.A, Factorisation(p.A, blocks).solve(b), b), 1e-13);
}

TEST(Factorisation, SolvesALargeMatrix) {
  const Problem p = quasi_definite(2100, true);
  const Vector b = p.scale.cwiseProduct(Vector::LinSpaced(p.A.rows(), -1., 2.));
  const Factorisation factors(p.A);
  EXPECT_LT(residual(p.A, factors.solve(b), b), 1e-13);
  EXPECT_EQ(factors.inertia().negative, p.n_negative);
  EXPECT_GT(factors.n_factor_entries(), p.A.nonZeros() / 2);
}

TEST(Factorisation, BlocksChangeNothing) {
  const Problem p = quasi_definite(30, true);
  const Vector b = p.scale.cwiseProduct(Vector::LinSpaced(p.A.rows(), 1., 2.));
  const Vector with = Factorisation(p.A, p.blocks).solve(b).cwiseProduct(p.scale);
  const Vector without = Factorisation(p.A).solve(b).cwiseProduct(p.scale);
  EXPECT_LT((with - without).norm(), 1e-12 * without.norm());
}

TEST(Factorisation, CountsPivotsBySign) {
  const Problem p = quasi_definite(25, true);
  for (const auto& blocks : {std::vector<IndexRange>{}, p.blocks}) {
    const Inertia inertia = Factorisation(p.A, blocks).inertia();
    EXPECT_EQ(inertia.negative, p.n_negative);
    EXPECT_EQ(inertia.positive, p.A.rows() - p.n_negative);
  }
}

// An incompressible fluid leaves zeros on the diagonal of phi; condensing W fills them.
TEST(Factorisation, ZeroDiagonalIsFilledByCondensation) {
  const Problem p = quasi_definite(25, true, true);
  const Factorisation factors(p.A, p.blocks);
  const Vector b = p.scale.cwiseProduct(Vector::LinSpaced(p.A.rows(), 1., 2.));
  EXPECT_LT(residual(p.A, factors.solve(b), b), 1e-12);
  EXPECT_EQ(factors.inertia().negative, p.n_negative);
}

TEST(Factorisation, RefactorEqualsANewOne) {
  const Problem p = quasi_definite(25, false), q = quasi_definite(25, false, false, 8);
  Factorisation factors(p.A, p.blocks);
  factors.refactor(q.A);
  const Vector b = Vector::LinSpaced(p.A.rows(), 1., 2.);
  EXPECT_EQ(factors.solve(b), Factorisation(q.A, q.blocks).solve(b));
  EXPECT_THROW(factors.refactor(quasi_definite(26, false).A), std::invalid_argument);
}

// A zero on the diagonal that is eliminated first is replaced, and solutions are refined by a matrix that is had anew.
TEST(Factorisation, EmptiesAMatrixThatItMayAndSolvesAlike) {
  const auto multiplier = [](double stiffness) {
    Eigen::MatrixXd dense(3, 3);
    dense << 0., 1., 0., 1., stiffness, 1., 0., 1., 3.;
    return SparseMatrix(dense.sparseView());
  };
  for (const bool refined : {false, true}) {
    const SparseMatrix first = refined ? multiplier(2.) : quasi_definite(25, false).A,
                       second = refined ? multiplier(5.) : quasi_definite(25, false, false, 8).A;
    const std::vector<IndexRange> blocks = refined ? std::vector<IndexRange>{} : quasi_definite(25, false).blocks;
    const Vector b = Vector::LinSpaced(first.rows(), 1., 2.);
    SparseMatrix given = first, other = second;
    int asked = 0;
    Factorisation factors(std::move(given), blocks, {}, [&] { return ++asked, first; });
    EXPECT_EQ(factors.has_halves(), !refined);
    EXPECT_EQ(given.nonZeros(), 0);
    EXPECT_EQ(factors.solve(b), Factorisation(first, blocks).solve(b));
    factors.refactor(std::move(other), [&] { return ++asked, second; });
    EXPECT_EQ(other.nonZeros(), 0);
    EXPECT_EQ(factors.solve(b), Factorisation(second, blocks).solve(b));
    EXPECT_EQ(asked, refined ? 2 : 0);
  }
}

// A solve in two halves: the first gives C^T A^-1 b, from which a law of contact may choose q; the second gives A^-1
// (b - C q).
TEST(Factorisation, IsHaltedHalfway) {
  const Problem p = quasi_definite(40, false);
  const int n = static_cast<int>(p.A.rows()), m = 11;  // more columns than one pass through the factor takes
  SparseMatrix C(n, m);
  for (int c = 0; c < m; ++c)
    for (const int i : {c, n / 2 + 2 * c, n - 1 - c}) C.coeffRef(i, c) += std::cos(3. * c + i);
  C.makeCompressed();
  const Vector b = Vector::LinSpaced(n, -1., 2.);
  for (const auto& blocks : {std::vector<IndexRange>{}, p.blocks}) {
    const Factorisation factors(p.A, blocks);
    ASSERT_TRUE(factors.has_halves());
    const Border border = factors.border(C);
    const Eigen::MatrixXd X = factors.solve_columns(Eigen::MatrixXd(C));
    const Eigen::MatrixXd gram = C.transpose() * X;
    EXPECT_LT((border.gram - gram).norm(), 1e-12 * gram.norm());
    for (const double size : {0., 1.}) {
      const Vector q = size * Vector::LinSpaced(m, 1., -2.), whole = factors.solve(b - C * q);
      const Vector along = C.transpose() * factors.solve(b);
      Vector left = b, x(n);
      EXPECT_LT((factors.begin(left, border) - along).norm(), 1e-12 * along.norm());
      factors.finish(left, border, q, x);
      EXPECT_LT((x - whole).norm(), 1e-12 * whole.norm());
      EXPECT_LT((left - (b - C * q)).norm(), 1e-14 * b.norm());
    }
  }
}

TEST(Factorisation, RefusesWhatItCannotSolve) {
  Problem p = quasi_definite(5, false);
  const int n = static_cast<int>(p.A.rows());
  SparseMatrix singular(n + 2, n + 2);  // two more unknowns that only see their difference: [1 -1; -1 1]
  singular.reserve(Eigen::VectorXi::Constant(n + 2, 40));
  for (int i = 0; i < n; ++i)
    for (SparseMatrix::InnerIterator it(p.A, i); it; ++it) singular.insert(i, it.col()) = it.value();
  for (int i : {n, n + 1})
    for (int j : {n, n + 1}) singular.insert(i, j) = i == j ? 1. : -1.;
  singular.makeCompressed();
  EXPECT_THROW(Factorisation{singular}, NumericsError);

  EXPECT_THROW(Factorisation(p.A, {{0, 4}, {3, 7}}), std::invalid_argument);
  EXPECT_THROW(Factorisation(p.A, {{20, 24}, {24, 28}}), std::invalid_argument) << "blocks that couple";
  const int phi = n - 1;
  EXPECT_THROW(Factorisation(p.A, {{phi, phi + 1}}), NumericsError) << "a block that is not positive definite";
  p.A.coeffRef(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Factorisation{p.A}, NumericsError);
}

}  // namespace factorisation_test
