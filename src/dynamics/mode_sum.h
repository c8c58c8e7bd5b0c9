// The innermost loop of a batch of waves.
#pragma once

#include <vector>

#include "lanes.h"

namespace upbead::detail {

/// Modes w(n + 1) = E w(n) + f_n that answer to samples f_n with y_n = Re sum_m reading_m w_m(n). Their number is
/// padded to a multiple of `lanes` by modes of zeros.
struct ModeTable {
  SplitArray E;
  SplitArray start;                 ///< w(0) for f_0 = 1
  std::vector<SplitArray> reading;  ///< one for each load
};

/// Number of samples that add_mode_sum() takes at a time.
constexpr int samples_at_a_time = 8;

/// Adds y_n to y for `n_samples`, a multiple of samples_at_a_time. w has the size of the modes; it is w(0) before and
/// w(n_samples) afterwards.
void add_mode_sum(const SplitArray& E, const SplitArray& reading, const double* f, Eigen::Index n_samples,
                  SplitArray& w, double* y);

}  // namespace upbead::detail
