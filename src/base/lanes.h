// Several numbers at a time.
#pragma once

#include <cmath>
#include <cstring>

// Registers of AVX2 and AVX-512 and their fused operations do 1.4 and 3.4 times as many multiplications as those that
// every x86-64 has. GCC compiles a function marked so for all three and picks one when the program starts. Not with the
// address sanitizer, whose checks are not up yet when that choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define UPBEAD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define UPBEAD_CLONES
#endif
// What a function marked so calls is compiled for all three only as a part of it.
#define UPBEAD_IN_CLONES __attribute__((always_inline)) inline

namespace upbead::detail {

constexpr int lanes = 8;

/// As many doubles as the widest registers hold; the compiler splits them where registers are narrower. Aligned for the
/// widest everywhere: else a function that is compiled for all would expect what its caller does not keep.
using Lanes __attribute__((vector_size(lanes * sizeof(double)), aligned(lanes * sizeof(double)))) = double;

inline void load(const double* from, Lanes& to) {
  std::memcpy(&to, from, sizeof to);
}

inline void store(const Lanes& from, double* to) {
  std::memcpy(to, &from, sizeof from);
}

/// In a file that is compiled with -fno-math-errno, several at a time.
UPBEAD_IN_CLONES void square_root(const Lanes& of, Lanes& root) {
  double values[lanes];
  store(of, values);
  for (double& value : values) value = std::sqrt(value);
  load(values, root);
}

}  // namespace upbead::detail
