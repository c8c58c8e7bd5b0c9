#include "triangular_solve.h"

#include <algorithm>

#include "slabs.h"

namespace upbead::detail {

int triangular_solve_work(const Supernodes& nodes) {
  int n = 0;
  for (int s = 0; s < nodes.count(); ++s) n = std::max(n, slab_width * n_tiles(nodes.height(s)));
  return n;
}

FactorView view(const Supernodes& nodes, const Factor& factor) {
  return {static_cast<int>(nodes.order.size()),
          nodes.n_eliminated(),
          nodes.first.data(),
          nodes.row_begin.data(),
          nodes.rows.data(),
          factor.entries.get(),
          factor.inverse_pivot.data()};
}

/// Measured (AMD EPYC, Zen 4): AVX2 saves a quarter of a solve where the factor lies in the cache; AVX-512 saves no
/// more.
static bool has_avx2() {
#ifdef UPBEAD_AVX2
  static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has;
#else
  return false;
#endif
}

const double* forward_half(const FactorView& factor, double* x, int n_columns, double* work) {
#ifdef UPBEAD_AVX2
  if (has_avx2()) return forward_avx2(factor, x, n_columns, work);
#endif
  return forward_baseline(factor, x, n_columns, work);
}

void backward_half(const FactorView& factor, const double* end, double* x, int n_columns, double* work) {
#ifdef UPBEAD_AVX2
  if (has_avx2()) return backward_avx2(factor, end, x, n_columns, work);
#endif
  backward_baseline(factor, end, x, n_columns, work);
}

}  // namespace upbead::detail
