// Several complex numbers at a time.
#pragma once

#include <Eigen/Core>
#include <cstring>

// Registers of AVX2 and AVX-512 and their fused operations do 1.4 and 3.4 times as many multiplications as those that
// every x86-64 has. GCC compiles a function marked so for all three and picks one when the program starts. Not with the
// address sanitizer, whose checks are not up yet when that choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define UPBEAD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define UPBEAD_CLONES
#endif

namespace upbead::detail {

/// Complex numbers as two arrays, so that a processor can take several at a time.
struct SplitArray {
  Eigen::ArrayXd re, im;
};

/// Left alone, modes would decay to denormal numbers, which are very slow, and stay there.
void flush_denormals(SplitArray& z);

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

/// Number of samples that add_mode_sum() takes at a time.
constexpr int samples_at_a_time = 8;

/// Of modes w(n + 1) = E w(n) + f_n: adds y_n = Re sum_m reading_m w_m(n) to y for `n_samples`, a multiple of
/// samples_at_a_time. Their number is a multiple of `lanes`; w is w(0) before and w(n_samples) afterwards.
void add_mode_sum(const SplitArray& E, const SplitArray& reading, const double* f, Eigen::Index n_samples,
                  SplitArray& w, double* y);

}  // namespace upbead::detail
