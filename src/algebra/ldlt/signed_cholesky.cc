#include "signed_cholesky.h"

#include <petscsys.h>
// after petscsys.h, which it needs
#include <petscblaslapack.h>

#include <algorithm>
#include <cmath>

#include "algebra/blas_turn.h"

namespace upbead::detail {

namespace {

constexpr int block_width = 24, product_width = 64;
constexpr double one = 1., minus_one = -1.;

/// Factorises the diagonal block at column `begin`, column by column; returns as `factorise` does.
int factorise_block(const Panel& panel, int begin, int end, int* sign, double stand_in) {
  for (int j = begin; j < end; ++j) {
    double* column = panel.column(j);
    double pivot = column[j];
    if (stand_in > 0. && std::abs(pivot) <= zero_pivot) pivot = sign[j] * stand_in;
    if (!(std::abs(pivot) > zero_pivot) || !std::isfinite(pivot)) return j;
    sign[j] = pivot > 0. ? 1 : -1;
    column[j] = std::sqrt(std::abs(pivot));
    for (int i = j + 1; i < end; ++i) column[i] *= sign[j] / column[j];
    for (int k = j + 1; k < end; ++k)
      for (int i = k; i < end; ++i) panel.column(k)[i] -= column[i] * sign[j] * column[k];
  }
  return end;
}

/// Rows below the diagonal block: A21 becomes L21 = A21 L11^-T J.
void solve_below(const Panel& panel, int begin, int end, const int* sign) {
  const PetscBLASInt n_rows = panel.height - end, n_columns = end - begin, height = panel.height;
  BLAStrsm_("R", "L", "T", "N", &n_rows, &n_columns, &one, panel.column(begin) + begin, &height,
            panel.column(begin) + end, &height);
  for (int j = begin; j < end; ++j)
    if (sign[j] < 0) std::transform(panel.column(j) + end, panel.column(j + 1), panel.column(j) + end, std::negate<>());
}

/// Columns right of the block, from the diagonal down: A -= L J L^T.
void update_right(const Panel& panel, int begin, int end, const int* sign, std::vector<double>& work) {
  const PetscBLASInt n_right = panel.width - end, n_block = end - begin, height = panel.height;
  work.resize(static_cast<std::size_t>(n_right) * n_block);
  for (int j = 0; j < n_block; ++j)
    for (int i = 0; i < n_right; ++i)
      work[i + static_cast<std::size_t>(j) * n_right] = sign[begin + j] * panel.column(begin + j)[end + i];
  for (int k = 0; k < n_right; k += product_width) {
    const PetscBLASInt n_columns = std::min(product_width, n_right - k), n_rows = height - end - k;
    BLASgemm_("N", "T", &n_rows, &n_columns, &n_block, &minus_one, panel.column(begin) + end + k, &height,
              work.data() + k, &n_right, &one, panel.column(end + k) + end + k, &height);
  }
}

}  // namespace

int factorise(const Panel& panel, int* sign, std::vector<double>& work, double stand_in) {
  const auto turn = blas_turn();
  for (int begin = 0; begin < panel.width; begin += block_width) {
    const int end = std::min(begin + block_width, panel.width);
    if (const int failed = factorise_block(panel, begin, end, sign, stand_in); failed < end) return failed;
    if (end < panel.height) solve_below(panel, begin, end, sign);
    if (end < panel.width) update_right(panel, begin, end, sign, work);
  }
  return panel.width;
}

void subtract_outer_product(const Panel& factor, const int* sign, double* U, std::vector<double>& work) {
  const PetscBLASInt n = factor.height - factor.width;
  if (n == 0) return;
  const auto turn = blas_turn();
  // columns sorted by sign: the product of each sign is a syrk, half the work of a full product
  work.resize(static_cast<std::size_t>(n) * factor.width);
  double* end = work.data();
  for (const int wanted : {1, -1}) {
    double* begin = end;
    PetscBLASInt n_columns = 0;
    for (int j = 0; j < factor.width; ++j) {
      if (sign[j] != wanted) continue;
      end = std::copy(factor.column(j) + factor.width, factor.column(j) + factor.height, end);
      ++n_columns;
    }
    const double weight = -wanted;
    if (n_columns > 0) BLASsyrk_("L", "N", &n, &n_columns, &weight, begin, &n, &one, U, &n);
  }
}

}  // namespace upbead::detail
