// Sparse matrices that are sums of small dense ones over groups of unknowns, as finite elements make them. The entries
// of all of them stand side by side, at places that are known beforehand: nothing is sorted while values are added.
#pragma once

#include <cstddef>
#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead::detail {

class PatternSums {
 public:
  /// `n_matrices` of n rows and columns. Any two unknowns of a group may have an entry; others must not.
  PatternSums(int n, int n_matrices, const std::vector<std::vector<int>>& groups);

  /// What is added from here on stands in this row.
  void begin_row(int row);
  /// Adds to a matrix, by its number, in the row begun; a column must share a group with it. A value of zero makes no
  /// entry.
  void add(int matrix, int column, double value) {
    if (value == 0.) return;
    values_[place_[static_cast<std::size_t>(column)] + static_cast<std::size_t>(matrix)] += value;
  }
  /// One of the matrices: the entries to which something was added, also where it sums to zero.
  SparseMatrix matrix(int which) const;

 private:
  void make_pattern(const std::vector<std::vector<int>>& groups);

  std::size_t n_matrices_;
  std::vector<std::size_t> first_;  ///< by row, of its entries in column_
  std::vector<int> column_;
  std::vector<double> values_;      ///< of all matrices, entry by entry
  std::vector<std::size_t> place_;  ///< by column, of the entry of the row begun in values_
  int row_ = -1;
};

}  // namespace upbead::detail
