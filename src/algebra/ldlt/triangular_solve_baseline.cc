#define UPBEAD_LANES 2
#include "factor_view.h"
#include "triangular_solve_kernels.h"

namespace upbead::detail {

const double* forward_baseline(const FactorView& factor, double* x, int n_columns, double* work) {
  return forward(factor, x, n_columns, work);
}

void backward_baseline(const FactorView& factor, const double* end, double* x, int n_columns, double* work) {
  backward(factor, end, x, n_columns, work);
}

}  // namespace upbead::detail
