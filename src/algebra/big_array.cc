#include "big_array.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace upbead::detail {

void FreeArray::operator()(double* data) const {
  std::free(data);
}

BigArray make_big_array(std::size_t n) {
  constexpr std::size_t cache_line = 64, huge_page = std::size_t{2} << 20;
  std::size_t bytes = n * sizeof(double);
  const std::size_t unit = bytes < 2 * huge_page ? cache_line : huge_page;
  bytes = (bytes / unit + 1) * unit;
  void* data = std::aligned_alloc(unit, bytes);
  if (data == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (unit == huge_page) madvise(data, bytes, MADV_HUGEPAGE);  // a wish; without it all works as well
#endif
  return BigArray(static_cast<double*>(data));
}

}  // namespace upbead::detail
