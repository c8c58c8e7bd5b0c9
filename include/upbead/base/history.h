// A history given by its values at some times.
#pragma once

#include <algorithm>
#include <vector>

namespace upbead {

/// Linear between its points; two points at one time make a jump.
struct History {
  std::vector<double> time;  ///< s, ascending
  std::vector<double> value;
};

/// The value at t of values given at ascending times: linear between them, the first value before them and the last one
/// after them.
template <class Values>
double value_at(const std::vector<double>& time, const Values& value, double t) {
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  if (next == 0) return value[0];
  if (next == static_cast<std::ptrdiff_t>(time.size())) return value[next - 1];
  const double part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return (1. - part) * value[next - 1] + part * value[next];
}

}  // namespace upbead
