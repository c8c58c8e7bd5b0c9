// Compiled with -mavx2 -mfma.
#define UPBEAD_LANES 4
#include "factor_view.h"
#include "triangular_solve_kernels.h"

namespace upbead::detail {

const double* forward_avx2(const FactorView& factor, double* x, int n_columns, double* work) {
  return forward(factor, x, n_columns, work);
}

void backward_avx2(const FactorView& factor, const double* end, double* x, int n_columns, double* work) {
  backward(factor, end, x, n_columns, work);
}

}  // namespace upbead::detail
