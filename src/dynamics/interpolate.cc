#include "dynamics/interpolate.h"

namespace upbead {

QuinticHermite::QuinticHermite(double t0, double h, const Jet& begin, const Jet& end) : t0_(t0), h_(h) {
  c_[0] = begin.value;
  c_[1] = h * begin.first;
  c_[2] = 0.5 * h * h * begin.second;
  // What the cubic remainder s^3 (c3 + c4 s + c5 s^2) must supply at s = 1: value, slope, curvature.
  const double value = end.value - c_[0] - c_[1] - c_[2];
  const double slope = h * end.first - c_[1] - 2. * c_[2];
  const double curvature = h * h * end.second - 2. * c_[2];
  c_[3] = 10. * value - 4. * slope + 0.5 * curvature;
  c_[4] = -15. * value + 7. * slope - curvature;
  c_[5] = 6. * value - 3. * slope + 0.5 * curvature;
}

Jet QuinticHermite::operator()(double t) const {
  const double s = (t - t0_) / h_;
  double value = 0., first = 0., half_second = 0.;
  for (int i = 5; i >= 0; --i) {
    half_second = half_second * s + first;
    first = first * s + value;
    value = value * s + c_[i];
  }
  return {value, first / h_, 2. * half_second / (h_ * h_)};
}

}  // namespace upbead
