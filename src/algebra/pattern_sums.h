// Sparse matrices that are sums of small dense ones over groups of unknowns, as in finite elements. The entries of
// all these matrices stand side by side, at places known beforehand: adding a value needs no sorting.
#pragma once

#include <cstddef>
#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead::detail {

class PatternSums {
 public:
  /// `n_matrices` of n rows and columns. Any two unknowns of a group may have an entry; others must not.
  PatternSums(int n, int n_matrices, const std::vector<std::vector<int>>& groups);

  /// Values are added to this row from here on.
  void begin_row(int row);
  /// Adds a value to matrix number `matrix`, in the row begun; its column must share a group with the row. A value of
  /// zero makes no entry.
  void add(int matrix, int column, double value) {
    if (value == 0.) return;
    values_[place_[static_cast<std::size_t>(column)] + static_cast<std::size_t>(matrix)] += value;
  }
  /// One of the matrices, with all entries to which something was added, also those that sum to zero.
  SparseMatrix matrix(int which) const;

 private:
  void make_pattern(const std::vector<std::vector<int>>& groups);

  std::size_t n_matrices_;
  std::vector<std::size_t> first_;  ///< by row: where its entries begin in column_
  std::vector<int> column_;
  std::vector<double> values_;      ///< of all matrices, entry by entry
  std::vector<std::size_t> place_;  ///< by column: place in values_ of its entry in the row begun
  int row_ = -1;
};

}  // namespace upbead::detail
