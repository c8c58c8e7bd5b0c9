// Complex numbers as a processor likes them.
#pragma once

#include <Eigen/Core>

namespace upbead::detail {

/// Complex numbers as two arrays, so that a processor can take several at a time.
struct SplitArray {
  Eigen::ArrayXd re, im;
};

/// Left alone, modes would decay to denormal numbers, which are very slow, and stay there.
void drop_what_is_gone(SplitArray& z);

}  // namespace upbead::detail
