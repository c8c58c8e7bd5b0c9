// A large array of doubles.
#pragma once

#include <cstddef>
#include <memory>

namespace upbead::detail {

struct FreeArray {
  void operator()(double* data) const;
};
using BigArray = std::unique_ptr<double[], FreeArray>;

/// Not initialised, aligned to cache lines; from 4 MB on in pages of 2 MB where the system has them (first use of the
/// factor of 50,000 unknowns: 46 ms instead of 56). Throws std::bad_alloc.
BigArray make_big_array(std::size_t n);

}  // namespace upbead::detail
