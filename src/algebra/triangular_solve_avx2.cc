// Compiled with -mavx2 -mfma.
#define UPBEAD_LANES 4
#include "triangular_solve_kernels.h"
#include "triangular_solve_variants.h"

namespace upbead::detail {

void triangular_solve_avx2(const FactorView& factor, double* x, int n_columns, double* work) {
  const double* end = forward(factor, x, n_columns, work);
  backward(factor, end, x, n_columns, work);
}

}  // namespace upbead::detail
