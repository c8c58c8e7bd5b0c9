#include "upbead/sliding/block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "force_pieces.h"
#include "slip_motion.h"

namespace upbead {

namespace {

using detail::ForcePiece;
using detail::Line;
using detail::SlipMotion;

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

class Block {
 public:
  Block(double mass, double drag) : mass_(mass), drag_(drag) {}

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
    sliding_.residual += slip_.distance;
    sliding_.path += std::abs(slip_.distance);
    if (std::abs(sliding_.residual) > std::abs(sliding_.largest)) sliding_.largest = sliding_.residual;
    sliding_.slips.push_back(slip_);
  }

  double mass_, drag_;
  int direction_ = 0;  ///< 0: at rest
  double speed_ = 0.;  ///< in that direction
  Slip slip_;
  Sliding sliding_;
};

}  // namespace

Sliding slide(double mass, const ForceHistory& force, const ForceHistory& resistance, double drag) {
  if (!(mass > 0. && std::isfinite(mass))) throw std::invalid_argument("the mass of a block must be positive");
  if (!(drag >= 0. && std::isfinite(drag))) throw std::invalid_argument("the drag on a block must not be negative");
  Block block(mass, drag);
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

Sliding slide(double mass, const ForceHistory& force, double resistance, double drag) {
  return slide(mass, force, ForceHistory{{0.}, {resistance}}, drag);
}

}  // namespace upbead
