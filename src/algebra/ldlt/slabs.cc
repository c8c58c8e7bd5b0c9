#include "slabs.h"

#include <algorithm>

namespace upbead::detail {

namespace {

void scale_to_unit_diagonal(const Panel& factor, const int* sign, double* inverse_pivot) {
  for (int j = 0; j < factor.width; ++j) {
    double* column = factor.column(j);
    const double diagonal = column[j];
    inverse_pivot[j] = sign[j] / (diagonal * diagonal);
    for (int i = j; i < factor.height; ++i) column[i] *= 1. / diagonal;
  }
}

/// M of the slab at column `begin`, by columns of `padded` rows, from the last column to the first:
/// m_j = -l_j - sum_(k > j) l_kj m_k, with l_j the part of column j of L below the diagonal.
void find_slab(const Panel& unit, int begin, int width, std::size_t padded, std::vector<double>& M) {
  M.assign(padded * static_cast<std::size_t>(width), 0.);
  const int n_rows = unit.height - begin;
  for (int j = width - 1; j >= 0; --j) {
    const double* l = unit.column(begin + j) + begin;
    double* m = M.data() + padded * static_cast<std::size_t>(j);
    for (int i = width; i < n_rows; ++i) m[i] = -l[i];
    for (int k = j + 1; k < width; ++k) {
      const double* right = M.data() + padded * static_cast<std::size_t>(k);
      m[k] -= l[k];
      for (int i = k + 1; i < n_rows; ++i) m[i] -= l[k] * right[i];
    }
  }
}

}  // namespace

std::size_t n_slab_entries(int height, int width) {
  std::size_t n = 0;
  for (int begin = 0; begin < width; begin += slab_width)
    n += static_cast<std::size_t>(n_tiles(height - begin)) * slab_width * std::min(slab_width, width - begin);
  return n;
}

void write_slabs(const Panel& factor, const int* sign, double* inverse_pivot, double* out, std::vector<double>& work) {
  scale_to_unit_diagonal(factor, sign, inverse_pivot);
  for (int begin = 0; begin < factor.width; begin += slab_width) {
    const int width = std::min(slab_width, factor.width - begin), tiles = n_tiles(factor.height - begin);
    const std::size_t padded = static_cast<std::size_t>(tiles) * slab_width;
    find_slab(factor, begin, width, padded, work);
    for (std::size_t tile = 0; tile < padded; tile += slab_width)
      for (int j = 0; j < width; ++j)
        out = std::copy_n(work.data() + padded * static_cast<std::size_t>(j) + tile, slab_width, out);
  }
}

}  // namespace upbead::detail
