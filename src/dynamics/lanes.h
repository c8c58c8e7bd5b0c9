// Several complex numbers at a time.
#pragma once

#include <Eigen/Core>

#include "base/lanes.h"

namespace upbead::detail {

/// Complex numbers as two arrays, so that a processor can take several at a time.
struct SplitArray {
  Eigen::ArrayXd re, im;
};

/// Sets tiny numbers to zero: decaying modes would become denormal numbers, which are very slow, and stay so.
void flush_denormals(SplitArray& z);

/// The values, padded by zeros to a multiple of `lanes`.
SplitArray padded(const Eigen::VectorXcd& values);

/// Number of samples that add_mode_sum() takes at a time.
constexpr int samples_at_a_time = 8;

/// For modes w(n + 1) = E w(n) + f_n: adds y_n = Re sum_m reading_m w_m(n) to y for `n_samples`, a multiple of
/// samples_at_a_time. The number of modes is a multiple of `lanes`; w is w(0) on entry and w(n_samples) on return.
void add_mode_sum(const SplitArray& E, const SplitArray& reading, const double* f, Eigen::Index n_samples,
                  SplitArray& w, double* y);

}  // namespace upbead::detail
