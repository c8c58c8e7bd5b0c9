// Dense Cholesky factors of symmetric matrices with positive and negative pivots.
#pragma once

#include <cstddef>
#include <vector>

namespace upbead::detail {

/// Columns of a symmetric matrix, from its diagonal down: height x width by columns, width <= height; nothing is read
/// above the diagonal.
struct Panel {
  double* data;
  int height;
  int width;
  double* column(int j) const { return data + std::ptrdiff_t{j} * height; }
};

/// Pivots up to this size count as zero, if the diagonal of the whole matrix was 1: they are round-off of a
/// cancellation.
constexpr double zero_pivot = 2.2e-14;

/// [A11; A21] becomes [L11; L21] with A11 = L11 J L11^T, A21 = L21 J L11^T, L11 lower triangular, J = diag(sign),
/// sign = +-1: Cholesky with the signs of the pivots carried along, without pivoting, for which A must be
/// quasi-definite (Vanderbei 1995). By blocks (Golub & Van Loan, Matrix Computations, 4.2.9). Returns the first
/// column whose pivot is zero or not finite, or the width where there is none. With `stand_in` > 0 a zero pivot is no
/// failure: stand_in replaces it, with the sign given in `sign` beforehand.
int factorise(const Panel& panel, int* sign, std::vector<double>& work, double stand_in = 0.);

/// U -= L21 J L21^T, lower triangle of U ((height - width) squared, by columns) only.
void subtract_outer_product(const Panel& factor, const int* sign, double* U, std::vector<double>& work);

}  // namespace upbead::detail
