// The two halves of a triangular solve for each instruction set.
#pragma once

#include "factor_view.h"

namespace upbead::detail {

/// x = D^-1 L^-1 x by the supernodes of `factor`; returns the end of their entries. Compiled for AVX2 with fused
/// multiply-add, and for what every processor of the platform has.
const double* forward_avx2(const FactorView& factor, double* x, int n_columns, double* work);
const double* forward_baseline(const FactorView& factor, double* x, int n_columns, double* work);
/// x = L^-T x; `end` is that of the entries.
void backward_avx2(const FactorView& factor, const double* end, double* x, int n_columns, double* work);
void backward_baseline(const FactorView& factor, const double* end, double* x, int n_columns, double* work);

}  // namespace upbead::detail
