#include "upbead/sliding/block.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/numbers.h"
#include "base/root.h"
#include "sliding/force_pieces.h"

namespace upbead {

namespace {

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

/// v' = a + jerk t - lambda v from v(0) = speed >= 0, while v > 0. Time in s from the start of the piece.
class SlipMotion {
 public:
  SlipMotion(double speed, double a, double jerk, double lambda) : speed_(speed), a_(a), jerk_(jerk), lambda_(lambda) {}

  /// v(t), not below 0.
  double speed(double t) const { return std::max(raw_speed(t), 0.); }
  /// Integral of v from 0 to t (m).
  double distance(double t) const {
    if (lambda_ == 0.) return t * (speed_ + t * (a_ / 2. + t * jerk_ / 6.));
    const double z = -lambda_ * t;
    return t * (speed_ * phi(1, z) + t * (a_ * phi(2, z) + t * jerk_ * phi(3, z)));
  }
  /// The time at which v is largest on [0, end].
  double fastest(double end) const {
    if (start() > 0.) return std::min(turn(), end);
    return raw_speed(end) > speed_ ? end : 0.;
  }
  /// The least t > 0 with v = 0; infinity where there is none on (0, end]. With drag v' is monotonic, so that v has
  /// at most one extremum, and the bracket of the first root is known.
  double stop(double end) const {
    if (lambda_ == 0.) return stop_of_parabola();
    const double extremum = std::min(turn(), end);
    const double from = jerk_ < 0. && extremum < end ? extremum : 0.;
    const double to = jerk_ > 0. ? extremum : end;
    if (raw_speed(to) > 0.) return infinity;
    if (!(raw_speed(from) > 0.)) return speed_ == 0. && jerk_ < 0. ? 2. * from : infinity;
    return root_bracket([this](double t) { return raw_speed(t); }, from, to, 52).second;
  }

 private:
  double raw_speed(double t) const {
    if (lambda_ == 0.) return speed_ + t * (a_ + t * jerk_ / 2.);
    const double z = -lambda_ * t;
    return speed_ * std::exp(z) + t * (a_ * phi(1, z) + t * jerk_ * phi(2, z));
  }
  double start() const { return a_ - lambda_ * speed_; }  ///< v'(0)
  /// The time t > 0 at which v' = 0; infinity where there is none.
  double turn() const {
    const double b = start();
    if (jerk_ == 0. || b / jerk_ >= 0.) return infinity;
    return lambda_ == 0. ? -b / jerk_ : std::log1p(-lambda_ * b / jerk_) / lambda_;
  }
  /// Roots without cancellation, after Press et al., Numerical Recipes, section 5.6.
  double stop_of_parabola() const {
    if (speed_ == 0.) return jerk_ < 0. ? -2. * a_ / jerk_ : infinity;  // the block has just started: a >= 0
    const double discriminant = a_ * a_ - 2. * jerk_ * speed_;
    if (discriminant < 0.) return infinity;
    const double q = -(a_ + std::copysign(std::sqrt(discriminant), a_));
    double first = infinity;
    for (const double root : {q / jerk_, 2. * speed_ / q})
      if (root > 0.) first = std::min(first, root);
    return first;
  }
  double speed_, a_, jerk_, lambda_;
};

/// sF - R: the force in direction s that exceeds the resistance.
Line net_force(const LinearPiece& piece, int s) {
  return {s * piece.first.begin - piece.second.begin, s * piece.first.end - piece.second.end};
}

/// Time until a resting block starts under `net` (s); the whole length where it does not start.
double time_to_start(const Line& net, double length) {
  if (net.begin > 0.) return 0.;
  if (net.end <= 0.) return length;
  return length * -net.begin / (net.end - net.begin);
}

class Block {
 public:
  Block(double mass, double drag) : mass_(mass), drag_(drag) {}

  /// Moves the block through a piece.
  void pass(LinearPiece piece) {
    int stopped = 0;  // direction of the slip that has just ended
    if (direction_ != 0 && speed_ == 0.) end_slip(piece.start);
    while (piece.length > 0.) {
      if (direction_ == 0) {
        piece = piece.after(rest(piece, stopped));
      } else {
        stopped = direction_;
        piece = piece.after(slip(piece));
      }
    }
  }

  double velocity() const { return direction_ * speed_; }
  const Sliding& result() const { return sliding_; }

 private:
  /// Waits for a start, and returns the time passed. The force that has just stopped the block does not push it, so a
  /// push by round-off is ignored.
  double rest(const LinearPiece& piece, int stopped) {
    double passed = piece.length;
    for (const int s : {1, -1}) {
      Line net = net_force(piece, s);
      if (s == stopped) net.begin = std::min(net.begin, 0.);
      const double start = time_to_start(net, piece.length);
      if (start >= passed) continue;
      passed = start;
      direction_ = s;
    }
    if (direction_ != 0) slip_ = {piece.start + passed, 0., 0., 0.};
    return passed;
  }

  /// Slips until the block stops or the piece ends, and returns the time passed.
  double slip(const LinearPiece& piece) {
    Line net = net_force(piece, direction_);
    if (speed_ == 0.) net.begin = std::max(net.begin, 0.);
    const SlipMotion motion(speed_, net.begin / mass_, (net.end - net.begin) / (mass_ * piece.length), drag_ / mass_);
    const double stop = motion.stop(piece.length), passed = std::min(stop, piece.length);
    note_speed(motion.speed(motion.fastest(passed)));
    slip_.distance += direction_ * motion.distance(passed);
    speed_ = passed == stop ? 0. : motion.speed(passed);
    if (passed == stop) end_slip(piece.start + passed);
    return passed;
  }

  void note_speed(double speed) {
    if (speed > std::abs(slip_.peak_velocity)) slip_.peak_velocity = direction_ * speed;
  }

  void end_slip(double time) {
    direction_ = 0;
    if (slip_.distance == 0.) return;
    slip_.stop = time;
    sliding_.add(slip_);
  }

  double mass_, drag_;
  int direction_ = 0;  ///< 0: at rest
  double speed_ = 0.;  ///< in that direction
  Slip slip_;
  Sliding sliding_;
};

}  // namespace

void Sliding::add(const Slip& slip) {
  residual += slip.distance;
  path += std::abs(slip.distance);
  if (std::abs(residual) > std::abs(largest)) largest = residual;
  slips.push_back(slip);
}

Sliding slide(double mass, const History& force, const History& resistance, double drag) {
  if (!(mass > 0. && std::isfinite(mass))) throw std::invalid_argument("the mass of a block must be positive");
  if (!(drag >= 0. && std::isfinite(drag))) throw std::invalid_argument("the drag on a block must not be negative");
  Block block(mass, drag);
  double end = 0.;
  for (const LinearPiece& piece : force_pieces(force, resistance)) {
    block.pass(piece);
    end = piece.start + piece.length;
  }
  const double end_velocity = block.velocity();
  if (end_velocity != 0.) {
    const double left = resistance.value.back();
    if (left <= 0.) throw std::invalid_argument("no resistance is left to stop the block");
    block.pass({end, 2. * mass * std::abs(end_velocity) / left, {0., 0.}, {left, left}});
  }
  Sliding result = block.result();
  result.end_velocity = end_velocity;
  return result;
}

Sliding slide(double mass, const History& force, double resistance, double drag) {
  return slide(mass, force, History{{0.}, {resistance}}, drag);
}

}  // namespace upbead
