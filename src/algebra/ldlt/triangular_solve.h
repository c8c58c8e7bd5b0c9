// Forward elimination and back substitution with the factor of a sparse symmetric matrix.
#pragma once

#include <functional>

#include "factor_view.h"
#include "multifrontal.h"

namespace upbead::detail {

/// What a solve does to the right-hand sides of the root supernode before it is eliminated (n_root x n_columns, the
/// columns n apart): sums them over processes.
using SumRoot = std::function<void(double* root, int n_columns)>;

/// x = (L D L^T)^-1 x for right-hand sides side by side, in elimination order: `x` is n x n_columns by columns. All go
/// through a slab while it is in the cache, each as if it were alone. `work` has triangular_solve_work(nodes) *
/// n_columns entries. Takes the vector instructions that the processor has. `sum_root`: where the root is shared.
void triangular_solve(const FactorView& factor, double* x, int n_columns, double* work, const SumRoot& sum_root = {});
/// Its halves, where no root is shared: x = D^-1 L^-1 x, and then x = L^-T x, which begins at the end of the factor's
/// entries that the first half returns.
const double* forward_half(const FactorView& factor, double* x, int n_columns, double* work);
void backward_half(const FactorView& factor, const double* end, double* x, int n_columns, double* work);
int triangular_solve_work(const Supernodes& nodes);
FactorView view(const Supernodes& nodes, const Factor& factor);

}  // namespace upbead::detail
