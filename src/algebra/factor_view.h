// The factor of a sparse symmetric matrix as plain arrays, for code that is compiled for several instruction sets.
#pragma once

namespace upbead::detail {

/// Columns of a slab, and rows of its tiles (see slabs.h).
constexpr int slab_width = 8;

/// See Supernodes and Factor, which own the arrays.
struct FactorView {
  int n;
  int n_supernodes;
  const int *first, *row_begin, *rows;
  const double *entries, *inverse_pivot;
};

}  // namespace upbead::detail
