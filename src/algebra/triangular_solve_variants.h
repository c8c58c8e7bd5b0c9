// The triangular solve for each instruction set.
#pragma once

#include "factor_view.h"

namespace upbead::detail {

/// As triangular_solve: compiled for AVX2 with fused multiply-add, and for what every processor of the platform has.
void triangular_solve_avx2(const FactorView& factor, double* x, int n_columns, double* work);
void triangular_solve_baseline(const FactorView& factor, double* x, int n_columns, double* work);

}  // namespace upbead::detail
