// Forward elimination and back substitution with the factor of a sparse symmetric matrix.
#pragma once

#include <functional>

#include "factor_view.h"
#include "multifrontal.h"

namespace upbead::detail {

/// Sums the right-hand sides of the root supernode over processes, before they are eliminated (n_root x n_columns,
/// the columns n apart).
using SumRoot = std::function<void(double* root, int n_columns)>;

/// x = (L D L^T)^-1 x for right-hand sides side by side, in elimination order: `x` is n x n_columns by columns. All
/// of them go through a slab while it is in the cache; each gets the same result as alone. `work` has
/// triangular_solve_work(nodes) * n_columns entries. Uses the vector instructions of the processor. `sum_root`: where
/// the root is shared.
void triangular_solve(const FactorView& factor, double* x, int n_columns, double* work, const SumRoot& sum_root = {});
/// The two halves of a solve, where no root is shared: x = D^-1 L^-1 x, and then x = L^-T x. The second begins at the
/// end of the factor's entries, which the first returns.
const double* forward_half(const FactorView& factor, double* x, int n_columns, double* work);
void backward_half(const FactorView& factor, const double* end, double* x, int n_columns, double* work);
int triangular_solve_work(const Supernodes& nodes);
FactorView view(const Supernodes& nodes, const Factor& factor);

}  // namespace upbead::detail
