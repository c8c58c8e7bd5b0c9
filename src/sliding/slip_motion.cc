#include "slip_motion.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace upbead::detail {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// phi_k(z) = sum_i z^i / (i + k)!, so that phi_0 = exp and phi_k = (phi_(k-1) - 1/(k-1)!) / z.
double phi(int k, double z) {
  if (std::abs(z) > 0.5) {  // the recurrence loses at most two digits there
    double value = std::exp(z), factorial = 1.;
    for (int i = 1; i <= k; ++i) {
      value = (value - 1. / factorial) / z;
      factorial *= i;
    }
    return value;
  }
  double term = 1.;
  for (int i = 2; i <= k; ++i) term /= i;
  double sum = term;
  for (int i = 1; i < 16; ++i) sum += term *= z / (i + k);
  return sum;
}

}  // namespace

double SlipMotion::raw_speed(double t) const {
  if (lambda_ == 0.) return speed_ + t * (a_ + t * jerk_ / 2.);
  const double z = -lambda_ * t;
  return speed_ * std::exp(z) + t * (a_ * phi(1, z) + t * jerk_ * phi(2, z));
}

double SlipMotion::speed(double t) const {
  return std::max(raw_speed(t), 0.);
}

double SlipMotion::distance(double t) const {
  if (lambda_ == 0.) return t * (speed_ + t * (a_ / 2. + t * jerk_ / 6.));
  const double z = -lambda_ * t;
  return t * (speed_ * phi(1, z) + t * (a_ * phi(2, z) + t * jerk_ * phi(3, z)));
}

double SlipMotion::turn() const {
  const double b = start();
  if (jerk_ == 0. || b / jerk_ >= 0.) return never;
  return lambda_ == 0. ? -b / jerk_ : std::log1p(-lambda_ * b / jerk_) / lambda_;
}

double SlipMotion::fastest(double end) const {
  if (start() > 0.) return std::min(turn(), end);
  return raw_speed(end) > speed_ ? end : 0.;
}

/// Roots without cancellation, after Press et al., Numerical Recipes, section 5.6.
double SlipMotion::stop_of_parabola() const {
  if (speed_ == 0.) return jerk_ < 0. ? -2. * a_ / jerk_ : never;  // it has just started: a >= 0
  const double discriminant = a_ * a_ - 2. * jerk_ * speed_;
  if (discriminant < 0.) return never;
  const double q = -(a_ + std::copysign(std::sqrt(discriminant), a_));
  double first = never;
  for (const double root : {q / jerk_, 2. * speed_ / q})
    if (root > 0.) first = std::min(first, root);
  return first;
}

/// With drag v' is monotonic, so that v has one extremum at most and what brackets the first root is known.
double SlipMotion::stop(double end) const {
  if (lambda_ == 0.) return stop_of_parabola();
  const double extremum = std::min(turn(), end);
  const double from = jerk_ < 0. && extremum < end ? extremum : 0.;
  const double to = jerk_ > 0. ? extremum : end;
  if (raw_speed(to) > 0.) return never;
  if (!(raw_speed(from) > 0.)) return speed_ == 0. && jerk_ < 0. ? 2. * from : never;
  boost::uintmax_t most = 100;
  const auto bracket = boost::math::tools::toms748_solve([this](double t) { return raw_speed(t); }, from, to,
                                                         boost::math::tools::eps_tolerance<double>(52), most);
  return bracket.second;
}

}  // namespace upbead::detail
