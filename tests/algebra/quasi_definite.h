// Random symmetric quasi-definite matrices.
#pragma once

#include <Eigen/Dense>
#include <random>

#include "upbead/algebra/sparse.h"

namespace upbead::test {

/// Symmetric, n x n, of diagonal +-1 (every third is negative), with about `per_row` random entries left of the
/// diagonal in each row. [H B'; B -G] with H and G dominated by their diagonals, B free, rows and columns shuffled.
inline SparseMatrix random_quasi_definite(int n, int per_row, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1., 1.);
  std::uniform_int_distribution<int> place(0, n - 1);
  const auto negative = [](int i) { return i % 3 == 2; };
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < n; ++i) {
    triplets.emplace_back(i, i, negative(i) ? -1. : 1.);
    for (int k = 0; k < per_row; ++k) {
      const int j = place(random);
      if (j == i) continue;
      const double value = negative(i) == negative(j) ? 0.2 / per_row * entry(random) : entry(random);
      triplets.emplace_back(i, j, value);
      triplets.emplace_back(j, i, value);
    }
  }
  SparseMatrix A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end(), [](double, double last) { return last; });
  return SparseMatrix((A + SparseMatrix(A.transpose())) * 0.5);
}

}  // namespace upbead::test
