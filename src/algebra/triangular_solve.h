// Forward elimination and back substitution with the factor of a sparse symmetric matrix.
#pragma once

#include "factor_view.h"
#include "multifrontal.h"

namespace upbead::detail {

/// x = (L D L^T)^-1 x for right-hand sides side by side, in elimination order: `x` is n x n_columns by columns. All go
/// through a slab while it is in the cache, each as if it were alone. `work` has triangular_solve_work(nodes) *
/// n_columns entries. Takes the vector instructions that the processor has.
void triangular_solve(const FactorView& factor, double* x, int n_columns, double* work);
int triangular_solve_work(const Supernodes& nodes);
FactorView view(const Supernodes& nodes, const Factor& factor);

}  // namespace upbead::detail
