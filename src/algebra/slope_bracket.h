// The least value of a convex function along a step, from its slopes.
#pragma once

#include <algorithm>
#include <cmath>

namespace upbead {

/// Lengths before and behind the least value. Slopes are those of the falling function, positive before it.
class SlopeBracket {
 public:
  /// `slope`: that at the start.
  explicit SlopeBracket(double slope) : start_(slope), near_slope_(slope) {}

  /// Whether a search may end with that slope.
  bool is_little(double slope) const { return std::abs(slope) <= 0.3 * std::abs(start_); }
  /// The length to be tried next. Until a length behind the least value is known, longer ones, by secants; then
  /// regula falsi, in which the slope of an end that stays is halved (Illinois).
  double after(double length, double slope) {
    if (slope > 0.) {
      near_ = length;
      near_slope_ = slope;
      if (far_slope_ == 0.) return length * std::clamp(start_ / std::max(start_ - slope, 1e-3 * start_), 2., 10.);
      far_slope_ *= 0.5;
    } else {
      if (far_slope_ < 0. || near_ > 0.) near_slope_ *= 0.5;
      far_ = length;
      far_slope_ = slope;
    }
    return near_ + (far_ - near_) * near_slope_ / (near_slope_ - far_slope_);
  }

 private:
  double start_, near_ = 0., near_slope_, far_ = 0., far_slope_ = 0.;  ///< far_slope_: 0 until one behind is known
};

}  // namespace upbead
