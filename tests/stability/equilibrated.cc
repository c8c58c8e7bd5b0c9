#include "equilibrated.h"

#include <cmath>

namespace upbead::test {

namespace {

Vector equilibration(const SparseMatrix& A) {
  Vector scale(A.rows());
  for (int i = 0; i < A.rows(); ++i) {
    double diagonal = 0., largest = 0.;
    for (SparseMatrix::InnerIterator it(A, i); it; ++it) {
      if (it.col() == i) diagonal = std::abs(it.value());
      largest = std::max(largest, std::abs(it.value()));
    }
    scale[i] = 1. / std::sqrt(diagonal > 0. ? diagonal : largest);
  }
  return scale;
}

}  // namespace

SolveError solve_error(const SparseMatrix& A, const Vector& x, const Vector& b) {
  const Vector scale = equilibration(A), scaled_b = scale.cwiseProduct(b), scaled_x = x.cwiseQuotient(scale);
  const SparseMatrix scaled_A = scale.asDiagonal() * A * scale.asDiagonal();
  const Vector residual = scaled_b - scaled_A * scaled_x;
  const Vector terms = scaled_A.cwiseAbs() * scaled_x.cwiseAbs() + scaled_b.cwiseAbs();
  return {residual.norm() / terms.norm(), residual.norm() / scaled_b.norm()};
}

}  // namespace upbead::test
