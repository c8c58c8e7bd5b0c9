// The extreme of a record.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace upbead {

/// Index of the value of largest magnitude, the first of equal ones; 0 of none.
inline std::size_t index_of_largest(const std::vector<double>& values) {
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end(), smaller) - values.begin());
}

}  // namespace upbead
