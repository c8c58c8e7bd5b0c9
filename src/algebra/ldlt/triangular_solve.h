// Forward elimination and back substitution with the factor of a sparse symmetric matrix.
#pragma once

#include "factor_view.h"
#include "multifrontal.h"

namespace upbead::detail {

/// The two halves of x = (L D L^T)^-1 x for right-hand sides side by side, in elimination order: `x` is n x n_columns
/// by columns. All of them go through a slab while it is in the cache; each gets the same result as alone. `work` has
/// triangular_solve_work(nodes) * n_columns entries. Uses the vector instructions of the processor.
///
/// x = D^-1 L^-1 x, and then x = L^-T x. The second begins at the end of the factor's entries, which the first returns.
/// Where there is a root, the first leaves b_root - A_ri A_ii^-1 b_i in it (i: what is eliminated), and the second
/// needs the solution there.
const double* forward_half(const FactorView& factor, double* x, int n_columns, double* work);
void backward_half(const FactorView& factor, const double* end, double* x, int n_columns, double* work);
int triangular_solve_work(const Supernodes& nodes);
FactorView view(const Supernodes& nodes, const Factor& factor);

}  // namespace upbead::detail
