// One thread at a time in BLAS and LAPACK.
#pragma once

#include <mutex>

namespace upbead::detail {

/// Hold it around calls of BLAS and LAPACK. The serial OpenBLAS has one set of work buffers that it hands out without a
/// lock: calls from two threads at once return wrong numbers, silently.
[[nodiscard]] inline std::unique_lock<std::mutex> blas_turn() {
  static std::mutex mutex;
  return std::unique_lock<std::mutex>(mutex);
}

}  // namespace upbead::detail
