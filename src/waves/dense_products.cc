#include "dense_products.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/lanes.h"

namespace upbead {

namespace {

using detail::Lanes;
using detail::lanes;

constexpr Eigen::Index tile = 4;    ///< columns of C at a time, which fit into registers
constexpr Eigen::Index panel = 16;  ///< columns of a Cholesky factor at a time

/// C += factor A A' in tiles that the lower triangle of the first n columns of C touches.
UPBEAD_CLONES void add_tiles(Eigen::Index n, Eigen::Index depth, double factor, const double* A, Eigen::Index A_stride,
                             double* C, Eigen::Index C_stride) {
  for (Eigen::Index j = 0; j < n; j += tile)
    for (Eigen::Index i = j / lanes * lanes; i < n; i += lanes) {
      Lanes sum[tile] = {};
      for (const double *a = A, *end = A + depth * A_stride; a != end; a += A_stride) {
        Lanes rows;
        detail::load(a + i, rows);
        for (Eigen::Index q = 0; q < tile; ++q) sum[q] += rows * a[j + q];
      }
      for (Eigen::Index q = 0; q < tile; ++q) {
        double* c = C + (j + q) * C_stride + i;
        Lanes before;
        detail::load(c, before);
        detail::store(before + factor * sum[q], c);
      }
    }
}

/// Columns from `from` to `to` of L from those of A that the columns before have been taken from.
UPBEAD_CLONES bool factor_panel(Eigen::Index from, Eigen::Index to, Eigen::Index rows, double* A, Eigen::Index stride) {
  for (Eigen::Index j = from; j < to; ++j) {
    double* column = A + j * stride;
    for (Eigen::Index p = from; p < j; ++p) {
      const double* before = A + p * stride;
      const double by = before[j];
      for (Eigen::Index i = j; i < rows; ++i) column[i] -= by * before[i];
    }
    if (!(column[j] > 0.)) return false;
    const double scale = 1. / std::sqrt(column[j]);
    for (Eigen::Index i = j; i < rows; ++i) column[i] *= scale;
  }
  return true;
}

}  // namespace

Eigen::Index padded(Eigen::Index rows) {
  return (rows + lanes - 1) / lanes * lanes;
}

void add_products(const Eigen::MatrixXd& A, Eigen::Index at, Eigen::MatrixXd& C) {
  add_tiles(A.rows(), A.cols(), 1., A.data(), A.rows(), &C(at, at), C.rows());
}

Eigen::VectorXd solve_positive(Eigen::MatrixXd& A, Eigen::Index n) {
  const Eigen::Index stride = A.rows();
  for (Eigen::Index from = 0; from < n; from += panel) {
    const Eigen::Index to = std::min(from + panel, n);
    if (!factor_panel(from, to, n + 1, A.data(), stride)) return {};
    if (to < n) add_tiles(n + 1 - to, panel, -1., &A(to, from), stride, &A(to, to), stride);
  }
  return -A.topLeftCorner(n, n).triangularView<Eigen::Lower>().transpose().solve(A.row(n).head(n).transpose());
}

}  // namespace upbead
