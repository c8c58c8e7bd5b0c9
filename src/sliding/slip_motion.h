// How a block moves while it slides and the force on it runs along a straight line.
#pragma once

namespace upbead::detail {

/// v' = a + jerk t - lambda v from v(0) = speed >= 0, while v > 0. Time in s from the start of the piece.
class SlipMotion {
 public:
  SlipMotion(double speed, double a, double jerk, double lambda) : speed_(speed), a_(a), jerk_(jerk), lambda_(lambda) {}

  /// v(t), not below 0.
  double speed(double t) const;
  /// Integral of v from 0 to t (m).
  double distance(double t) const;
  /// The time at which v is largest on [0, end].
  double fastest(double end) const;
  /// The least t > 0 with v = 0; infinity where there is none on (0, end].
  double stop(double end) const;

 private:
  double raw_speed(double t) const;
  double start() const { return a_ - lambda_ * speed_; }  ///< v'(0)
  /// Where v' = 0, beyond 0; infinity where it is nowhere.
  double turn() const;
  double stop_of_parabola() const;
  double speed_, a_, jerk_, lambda_;
};

}  // namespace upbead::detail
