// The factor of a sparse symmetric matrix as plain arrays, and the two halves of a solve with it, for code that is
// compiled for several instruction sets.
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

/// x = D^-1 L^-1 x by the supernodes of `factor`; returns the end of its entries. Compiled twice: for AVX2 with fused
/// multiply-add, and for every processor of the platform.
const double* forward_avx2(const FactorView& factor, double* x, int n_columns, double* work);
const double* forward_baseline(const FactorView& factor, double* x, int n_columns, double* work);
/// x = L^-T x; `end` is the end of the entries.
void backward_avx2(const FactorView& factor, const double* end, double* x, int n_columns, double* work);
void backward_baseline(const FactorView& factor, const double* end, double* x, int n_columns, double* work);

}  // namespace upbead::detail
