// The loops of a triangular solve, for vectors of `lanes` doubles. Included by one source file for each instruction
// set, which is compiled with that set's options. Everything is local to that file and no library code is used, so
// that no other file gets instructions that its processor may lack.
#pragma once

#include <cstddef>

#include "factor_view.h"

namespace upbead::detail {
namespace {

// vector types of GCC and Clang, at any address
using Lanes [[gnu::vector_size(UPBEAD_LANES * sizeof(double)), gnu::aligned(alignof(double))]] = double;
constexpr int lanes = UPBEAD_LANES;

Lanes& at(double* p) {
  return *reinterpret_cast<Lanes*>(p);
}
const Lanes& at(const double* p) {
  return *reinterpret_cast<const Lanes*>(p);
}

/// t += M t_slab. Two sums, so that a product need not wait for the one before.
template <int width>
[[gnu::always_inline]] inline void eliminate(const double* M, int tiles, double* t) {
  double x[width];
  for (int j = 0; j < width; ++j) x[j] = t[j];
  for (int tile = 0; tile < tiles; ++tile, M += slab_width * width, t += slab_width)
    for (int row = 0; row < slab_width; row += lanes) {
      Lanes even = at(t + row), odd{};
      for (int j = 0; j < width; j += 2) {
        even += at(M + slab_width * j + row) * x[j];
        if (j + 1 < width) odd += at(M + slab_width * (j + 1) + row) * x[j + 1];
      }
      at(t + row) = even + odd;
    }
}

/// t_slab += M^T t. Reads M strictly backwards, which the processor then fetches ahead of its use: reading the columns
/// of a tile forwards takes twice as long where the factor is larger than the cache.
template <int width>
[[gnu::always_inline]] inline void substitute(const double* M, int tiles, double* t) {
  Lanes sum[width] = {};
  for (int tile = tiles - 1; tile >= 0; --tile) {
    const double* m = M + slab_width * width * static_cast<std::ptrdiff_t>(tile);
    for (int row = 0; row < slab_width; row += lanes) {
      const Lanes y = at(t + slab_width * tile + row);
      for (int j = width - 1; j >= 0; --j) sum[j] += at(m + slab_width * j + row) * y;
    }
  }
  for (int j = 0; j < width; ++j)
    for (int lane = 0; lane < lanes; ++lane) t[j] += sum[j][lane];
}

template <int n>
struct Width {
  static constexpr int value = n;
};

/// Calls `call` with a width that the compiler knows. Written out so that the loops are inlined: calls through
/// pointers cost a fifth of a solve where the factor lies in the cache.
template <class Call>
[[gnu::always_inline]] inline void with_width(int width, const Call& call) {
  switch (width) {
    case 1:
      return call(Width<1>());
    case 2:
      return call(Width<2>());
    case 3:
      return call(Width<3>());
    case 4:
      return call(Width<4>());
    case 5:
      return call(Width<5>());
    case 6:
      return call(Width<6>());
    case 7:
      return call(Width<7>());
    default:
      return call(Width<slab_width>());
  }
}
static_assert(slab_width == 8 && slab_width % lanes == 0);

/// A supernode and where its part of each right-hand side is gathered.
struct Front {
  Front(const FactorView& factor, int s)
      : begin(factor.first[s]),
        width(factor.first[s + 1] - begin),
        height(factor.row_begin[s + 1] - factor.row_begin[s]),
        tiles((height + slab_width - 1) / slab_width),
        rows(factor.rows + factor.row_begin[s]) {}

  int width_of_slab(int j) const { return width - j < slab_width ? width - j : slab_width; }
  int tiles_of_slab(int j) const { return tiles - j / slab_width; }
  std::ptrdiff_t entries_of_slab(int j) const {
    return static_cast<std::ptrdiff_t>(slab_width) * width_of_slab(j) * tiles_of_slab(j);
  }
  double* part(double* work, int column) const {
    return work + static_cast<std::ptrdiff_t>(slab_width) * tiles * column;
  }

  int begin, width, height, tiles;
  const int* rows;
};

double* column(double* x, const FactorView& factor, int c) {
  return x + static_cast<std::ptrdiff_t>(c) * factor.n;
}

/// x = D^-1 L^-1 x; returns the end of the factor's entries.
const double* forward(const FactorView& factor, double* x, int n_columns, double* work) {
  const double* M = factor.entries;
  for (int s = 0; s < factor.n_supernodes; ++s) {
    const Front front(factor, s);
    for (int c = 0; c < n_columns; ++c) {
      double *t = front.part(work, c), *own = column(x, factor, c) + front.begin;
      for (int i = 0; i < front.width; ++i) t[i] = own[i];
      for (int i = front.width; i < slab_width * front.tiles; ++i) t[i] = 0.;
    }
    for (int j = 0; j < front.width; j += slab_width) {
      for (int c = 0; c < n_columns; ++c)
        with_width(front.width_of_slab(j), [&](auto width) {
          eliminate<decltype(width)::value>(M, front.tiles_of_slab(j), front.part(work, c) + j);
        });
      M += front.entries_of_slab(j);
    }
    for (int c = 0; c < n_columns; ++c) {
      const double* t = front.part(work, c);
      double* y = column(x, factor, c);
      for (int i = 0; i < front.width; ++i) y[front.begin + i] = t[i] * factor.inverse_pivot[front.begin + i];
      for (int i = front.width; i < front.height; ++i) y[front.rows[i]] += t[i];
    }
  }
  return M;
}

/// x = L^-T x; `M` is the end of the factor's entries.
void backward(const FactorView& factor, const double* M, double* x, int n_columns, double* work) {
  for (int s = factor.n_supernodes - 1; s >= 0; --s) {
    const Front front(factor, s);
    for (int c = 0; c < n_columns; ++c) {
      double *t = front.part(work, c), *y = column(x, factor, c);
      for (int i = 0; i < front.height; ++i) t[i] = y[front.rows[i]];
      for (int i = front.height; i < slab_width * front.tiles; ++i) t[i] = 0.;
    }
    for (int j = (front.width - 1) / slab_width * slab_width; j >= 0; j -= slab_width) {
      M -= front.entries_of_slab(j);
      for (int c = 0; c < n_columns; ++c)
        with_width(front.width_of_slab(j), [&](auto width) {
          substitute<decltype(width)::value>(M, front.tiles_of_slab(j), front.part(work, c) + j);
        });
    }
    for (int c = 0; c < n_columns; ++c) {
      double *t = front.part(work, c), *own = column(x, factor, c) + front.begin;
      for (int i = 0; i < front.width; ++i) own[i] = t[i];
    }
  }
}

}  // namespace
}  // namespace upbead::detail
