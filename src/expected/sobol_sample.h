// The sample for Sobol indices: two matrices of random points, and the first with one column of the second.
#pragma once

#include <cstdint>
#include <vector>

namespace upbead {

/// Most keys of a Sobol sample: Boost has direction numbers for 3,667 dimensions, two for each key.
constexpr int most_sobol_keys = 1833;

/// The scheme of Saltelli et al. (2010, table 2): n points of 2 d probabilities, the first d of which are a row of A,
/// the others of B; and d rows of A with one value of B. Its rows stand point by point, so that more points leave the
/// first ones as they are: row i (d + 2) is row i of A, the next that of B, then A with the first value of B, and so
/// on.
///
/// Points are those of Sobol's sequence from its first one, 0 (Owen 2020: without it 2^k points are no net), moved by a
/// random digital shift, by which the means are unbiased and no probability is 0 (Dick and Pillichshammer 2010, 4.4).
class SobolSample {
 public:
  SobolSample(int n_points, int n_keys, std::uint64_t seed);
  int n_rows() const { return n_points_ * (n_keys_ + 2); }
  int point(int row) const { return row / (n_keys_ + 2); }
  /// 0: A, 1: B, 2 + k: A with the value of key k of B.
  int matrix(int row) const { return row % (n_keys_ + 2); }
  /// In (0, 1).
  double probability(int row, int key) const;

 private:
  int n_points_, n_keys_;
  std::vector<double> points_;  ///< 2 d of each point
};

}  // namespace upbead
