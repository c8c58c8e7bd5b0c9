// Columns of the triangular factor of a sparse symmetric matrix that share their pattern.
#pragma once

#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead::detail {

/// The elimination order of the unknowns and the pattern of L, cut into supernodes: runs of columns of L with the
/// same pattern below their triangle. Children come before their parents, and all descendants of a supernode stand
/// right before it (postorder).
struct Supernodes {
  std::vector<int> order;      ///< order[k]: the unknown that is eliminated k-th
  std::vector<int> first;      ///< first column of each supernode; n at the end
  std::vector<int> row_begin;  ///< where the rows of each supernode begin in `rows`
  std::vector<int> rows;       ///< ascending, in elimination order; a supernode's own columns come first
  std::vector<int> parent;     ///< the supernode that holds the first row below the triangle; -1: none
  bool has_root = false;       ///< the last supernode is a root, which is left when all others are eliminated

  /// Supernodes that are eliminated.
  int n_eliminated() const { return count() - (has_root ? 1 : 0); }
  int n_root() const { return has_root ? width(count() - 1) : 0; }
  int count() const { return static_cast<int>(parent.size()); }
  int width(int s) const { return first[s + 1] - first[s]; }
  int height(int s) const { return row_begin[s + 1] - row_begin[s]; }
};

/// Orders by approximate minimum degree and merges small supernodes, both by CHOLMOD (Chen, Davis, Hager &
/// Rajamanickam, ACM Trans. Math. Softw. 35 (2008) 22). Reads the pattern of the lower triangle of A. Throws
/// NumericsError where CHOLMOD fails.
///
/// The `last` unknowns (ascending) come last, in this order, and are the columns of the root. It is taken as dense, as
/// the Schur complement in it is. The ordering of the other unknowns takes account of it (constrained minimum degree,
/// CAMD).
Supernodes find_supernodes(const SparseMatrix& A, const std::vector<int>& last = {});

}  // namespace upbead::detail
