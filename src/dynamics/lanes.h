// Several modes at a time.
#pragma once

#include <cstring>

#include "dynamics/split_array.h"

// Registers of AVX2 and AVX-512 and their fused operations do 1.4 and 3.4 times as many multiplications as those that
// every x86-64 has. GCC compiles a function marked so for all three and picks one when the program starts. Not with the
// address sanitizer, whose checks are not up yet when that choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define UPBEAD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define UPBEAD_CLONES
#endif

namespace upbead::detail {

constexpr int lanes = 8;

/// As many doubles as the widest registers hold; the compiler splits them where registers are narrower.
using Lanes __attribute__((vector_size(lanes * sizeof(double)))) = double;

inline void load(const double* from, Lanes& to) {
  std::memcpy(&to, from, sizeof to);
}

inline void store(const Lanes& from, double* to) {
  std::memcpy(to, &from, sizeof from);
}

/// Padded by zeros to a multiple of `lanes`.
SplitArray padded(const Eigen::VectorXcd& values);

}  // namespace upbead::detail
