// A history that is known by its values at times.
#pragma once

#include <algorithm>
#include <vector>

namespace upbead {

/// Straight between its points; two points at one time make a jump.
struct History {
  std::vector<double> time;  ///< s, ascending
  std::vector<double> value;
};

/// One of values at ascending times, straight between; the ends are kept beyond.
template <class Values>
double value_at(const std::vector<double>& time, const Values& value, double t) {
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  if (next == 0) return value[0];
  if (next == static_cast<std::ptrdiff_t>(time.size())) return value[next - 1];
  const double part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return (1. - part) * value[next - 1] + part * value[next];
}

}  // namespace upbead
