#include "algebra/pattern_sums.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace upbead::detail {
namespace pattern_sums_test {

using Triplets = std::vector<Eigen::Triplet<double>>;

SparseMatrix of_triplets(int n, const Triplets& triplets) {
  SparseMatrix A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

void expect_same(const SparseMatrix& A, const SparseMatrix& B) {
  ASSERT_EQ(A.nonZeros(), B.nonZeros());
  for (int i = 0; i < A.rows(); ++i)
    for (SparseMatrix::InnerIterator a(A, i), b(B, i); a; ++a, ++b) {
      ASSERT_EQ(a.col(), b.col()) << "row " << i;
      ASSERT_EQ(a.value(), b.value()) << "row " << i;
    }
}

// Values are summed in the order in which they come, as setFromTriplets does: the same to the last bit
TEST(PatternSums, AreThoseOfTriplets) {
  constexpr int n = 40, n_groups = 25, size = 6;
  std::mt19937 random(7);
  std::uniform_int_distribution<int> unknown(0, n - 1);
  std::normal_distribution<double> value;
  std::vector<std::vector<int>> groups(n_groups, std::vector<int>(size));
  for (std::vector<int>& group : groups)
    for (int& i : group) i = unknown(random);  // some twice
  PatternSums sums(n, 2, groups);
  std::array<Triplets, 2> triplets;
  for (const std::vector<int>& group : groups)
    for (const int i : group) {
      sums.begin_row(i);
      for (const int j : group)
        for (int m = 0; m < 2; ++m) {
          if (m == 1 && (i + j) % 3 == 0) continue;  // the matrices differ in their entries
          const double v = value(random);
          sums.add(m, j, v);
          triplets[static_cast<std::size_t>(m)].emplace_back(i, j, v);
        }
    }
  for (int m = 0; m < 2; ++m) expect_same(sums.matrix(m), of_triplets(n, triplets[static_cast<std::size_t>(m)]));
}

// Whether values cancel depends on rounding; the pattern must not depend on it
TEST(PatternSums, KeepWhatCancelsAndNoZeros) {
  PatternSums sums(3, 1, {{0, 1, 2}});
  sums.begin_row(0);
  sums.add(0, 1, 0.1);
  sums.add(0, 1, -0.1);
  sums.add(0, 2, 0.);
  sums.begin_row(2);
  sums.add(0, 2, -5.);
  const SparseMatrix A = sums.matrix(0);
  EXPECT_EQ(A.nonZeros(), 2);
  EXPECT_EQ(A.coeff(0, 1), 0.);
  EXPECT_EQ(A.coeff(2, 2), -5.);
}

}  // namespace pattern_sums_test
}  // namespace upbead::detail
