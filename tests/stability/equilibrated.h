// How well a system of equations was solved, in equilibrated variables.
#pragma once

#include "upbead/algebra/sparse.h"

namespace upbead::test {

/// Errors of a computed solution x of A x = b, with rows and columns of A scaled by 1/sqrt|a_ii| (if that is zero,
/// the largest entry of the row in its place): A^ = S A S, x^ = x/S, b^ = S b. Norms are Euclidean.
struct SolveError {
  double residual = 0.;  ///< |b^ - A^ x^| over | |A^||x^| + |b^| |: over the terms that cancel in it
  double plain = 0.;     ///< |b^ - A^ x^| / |b^|, which cannot be small where the terms are much larger than b^
};

SolveError solve_error(const SparseMatrix& A, const Vector& x, const Vector& b);

}  // namespace upbead::test
