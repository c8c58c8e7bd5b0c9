#include "upbead/sliding/block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "force_pieces.h"

namespace upbead {

namespace {

using detail::ForcePiece;
using detail::Line;

/// sF - R: what pushes the block in direction s beyond what friction takes.
Line net_force(const ForcePiece& piece, int s) {
  return {s * piece.force.begin - piece.resistance.begin, s * piece.force.end - piece.resistance.end};
}

/// Seconds until a resting block starts, where `net` pushes it; the whole length where it does not.
double time_to_start(const Line& net, double length) {
  if (net.begin > 0.) return 0.;
  if (net.end <= 0.) return length;
  return length * -net.begin / (net.end - net.begin);
}

/// The least t > 0 with speed + a t + jerk t^2 / 2 = 0, speed >= 0; infinity where there is none. Roots without
/// cancellation, after Press et al., Numerical Recipes, section 5.6.
double time_to_stop(double speed, double a, double jerk) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (speed == 0.) return jerk < 0. ? -2. * a / jerk : never;  // it has just started: a >= 0
  const double discriminant = a * a - 2. * jerk * speed;
  if (discriminant < 0.) return never;
  const double q = -(a + std::copysign(std::sqrt(discriminant), a));
  double first = never;
  for (const double root : {q / jerk, 2. * speed / q})
    if (root > 0.) first = std::min(first, root);
  return first;
}

class Block {
 public:
  explicit Block(double mass) : mass_(mass) {}

  /// Goes through a piece.
  void pass(ForcePiece piece) {
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

  double speed() const { return speed_; }
  const Sliding& result() const { return sliding_; }

 private:
  /// Waits for a start. The force that has just stopped the block does not push it, whatever round-off says.
  double rest(const ForcePiece& piece, int stopped) {
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

  /// Slips until the block stops or the piece ends.
  double slip(const ForcePiece& piece) {
    Line net = net_force(piece, direction_);
    if (speed_ == 0.) net.begin = std::max(net.begin, 0.);
    const double a = net.begin / mass_, jerk = (net.end - net.begin) / (mass_ * piece.length);
    const double stop = time_to_stop(speed_, a, jerk), passed = std::min(stop, piece.length);
    const auto speed_at = [&](double t) { return speed_ + t * (a + t * jerk / 2.); };
    const double turn = a > 0. && jerk < 0. ? std::min(-a / jerk, passed) : passed;
    note_speed(std::max(speed_, speed_at(turn)));
    slip_.distance += direction_ * passed * (speed_ + passed * (a / 2. + passed * jerk / 6.));
    speed_ = passed == stop ? 0. : std::max(speed_at(passed), 0.);
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
    sliding_.residual += slip_.distance;
    sliding_.path += std::abs(slip_.distance);
    if (std::abs(sliding_.residual) > std::abs(sliding_.largest)) sliding_.largest = sliding_.residual;
    sliding_.slips.push_back(slip_);
  }

  double mass_;
  int direction_ = 0;  ///< 0: at rest
  double speed_ = 0.;  ///< in that direction
  Slip slip_;
  Sliding sliding_;
};

}  // namespace

Sliding slide(double mass, const ForceHistory& force, const ForceHistory& resistance) {
  if (!(mass > 0. && std::isfinite(mass))) throw std::invalid_argument("the mass of a block must be positive");
  Block block(mass);
  double end = 0.;
  for (const ForcePiece& piece : detail::force_pieces(force, resistance)) {
    block.pass(piece);
    end = piece.start + piece.length;
  }
  if (block.speed() > 0.) {
    const double left = resistance.value.back();
    if (left <= 0.) throw std::invalid_argument("no resistance is left to stop the block");
    block.pass({end, 2. * mass * block.speed() / left, {0., 0.}, {left, left}});
  }
  return block.result();
}

Sliding slide(double mass, const ForceHistory& force, double resistance) {
  return slide(mass, force, ForceHistory{{0.}, {resistance}});
}

}  // namespace upbead
