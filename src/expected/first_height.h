// The height from which waves matter.
#pragma once

#include <functional>

namespace upbead::detail {

/// Where an increasing function of the height (m) is no longer negative, from below: it is negative there or at the
/// last digit. Infinity where it is negative up to 1 km.
double first_height(const std::function<double(double)>& f);

}  // namespace upbead::detail
