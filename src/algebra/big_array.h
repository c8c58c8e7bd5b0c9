// A large array of doubles.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace upbead::detail {

struct FreeArray {
  void operator()(double* data) const { std::free(data); }
};
using BigArray = std::unique_ptr<double[], FreeArray>;

/// Not initialised, aligned to cache lines; from 4 MB on in pages of 2 MB where the system has them (first use of the
/// factor of 50,000 unknowns: 46 ms instead of 56). Throws std::bad_alloc.
inline BigArray make_big_array(std::size_t n) {
  constexpr std::size_t cache_line = 64, huge_page = std::size_t{2} << 20;
  std::size_t bytes = n * sizeof(double);
  const std::size_t unit = bytes < 2 * huge_page ? cache_line : huge_page;
  bytes = (bytes / unit + 1) * unit;
  void* data = std::aligned_alloc(unit, bytes);
  if (data == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (unit == huge_page) madvise(data, bytes, MADV_HUGEPAGE);  // only a hint to the system
#endif
  return BigArray(static_cast<double*>(data));
}

}  // namespace upbead::detail
