// Arithmetic with several numbers at a time (SIMD).
#pragma once

#include <cmath>
#include <cstring>

// Registers of AVX2 and AVX-512 and their fused operations do 1.4 and 3.4 times as many multiplications as those that
// every x86-64 has. GCC compiles a function with this mark for all three and picks one when the program starts. Not
// with the address sanitizer, which is not ready yet when that choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define UPBEAD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define UPBEAD_CLONES
#endif
// A function called by one with that mark is compiled for all three only if it is inlined.
#define UPBEAD_IN_CLONES __attribute__((always_inline)) inline

namespace upbead::detail {

constexpr int lanes = 8;

/// As many doubles as the widest registers hold; the compiler splits them where registers are narrower. Aligned for
/// the widest registers on every machine, so that the three versions of a function and their caller agree.
using Lanes __attribute__((vector_size(lanes * sizeof(double)), aligned(lanes * sizeof(double)))) = double;

inline void load(const double* from, Lanes& to) {
  std::memcpy(&to, from, sizeof to);
}

inline void store(const Lanes& from, double* to) {
  std::memcpy(to, &from, sizeof from);
}

/// The compiler takes several roots at a time only in a file compiled with -fno-math-errno.
UPBEAD_IN_CLONES void square_root(const Lanes& of, Lanes& root) {
  double values[lanes];
  store(of, values);
  for (double& value : values) value = std::sqrt(value);
  load(values, root);
}

}  // namespace upbead::detail
