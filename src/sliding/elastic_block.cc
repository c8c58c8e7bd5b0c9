#include "sliding/elastic_block.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "base/numbers.h"
#include "base/root.h"
#include "sliding/force_pieces.h"

namespace upbead {

namespace {

/// Displacement and velocity.
struct Motion {
  double x = 0., v = 0.;
};

/// Solves mass x'' + damping x' + stiffness x = force, exactly. Without mass it is a bare spring: damping must be 0.
class Oscillator {
 public:
  Oscillator(double mass, double damping, double stiffness) : mass_(mass), damping_(damping), stiffness_(stiffness) {
    if (mass == 0.) return;
    const std::complex<double> half(-damping / (2. * mass), 0.);
    std::complex<double> split = std::sqrt(half * half - stiffness / mass);
    // two equal roots would need another formula: they are moved apart by a negligible amount
    if (std::abs(split) < 1e-6 * std::abs(half)) split = 1e-6 * half;
    root_[0] = half + split;
    root_[1] = half - split;
  }
  /// After t seconds from `start` under force + slope t.
  /// x = A exp(r_0 t) + B exp(r_1 t) + (force + slope t)/k - c slope/k^2.
  Motion after(double t, const Motion& start, double force, double slope) const {
    const double v_static = slope / stiffness_, x_static = force / stiffness_ - damping_ * v_static / stiffness_;
    if (mass_ == 0.) return {x_static + v_static * t, v_static};
    const double dx = start.x - x_static, dv = start.v - v_static;
    const std::complex<double> B = (dv - root_[0] * dx) / (root_[1] - root_[0]), A = dx - B;
    const std::complex<double> a = A * std::exp(root_[0] * t), b = B * std::exp(root_[1] * t);
    return {(a + b).real() + x_static + v_static * t, (root_[0] * a + root_[1] * b).real() + v_static};
  }
  double acceleration(const Motion& at, double force) const {
    return mass_ == 0. ? 0. : (force - damping_ * at.v - stiffness_ * at.x) / mass_;
  }
  /// 2 pi sqrt(mass/stiffness); 0 without mass (s).
  double natural_period() const { return two_pi * std::sqrt(mass_ / stiffness_); }

 private:
  double mass_, damping_, stiffness_;
  std::complex<double> root_[2];  ///< of mass s^2 + damping s + stiffness
};

constexpr int looks_per_period = 60;

/// A stretch of time on which P is force + slope t.
struct Stretch {
  double start = 0., length = 0., force = 0., slope = 0.;
  double at(double t) const { return force + slope * t; }
  Stretch after(double t) const { return {start + t, length - t, at(t), slope}; }
};

template <class Function>
double first_root(const Function& f, double length) {
  return root_bracket(f, 0., length, 50).second;
}

class BlockOnBase {
 public:
  BlockOnBase(double mass, const ElasticBase& base, double resistance)
      : mass_(mass),
        R_(resistance),
        together_(mass + base.mass, base.damping, base.stiffness),
        base_(base.mass, base.damping, base.stiffness) {
    const double alone = base_.natural_period();
    look_ = (alone > 0. ? std::min(alone, together_.natural_period()) : together_.natural_period()) / looks_per_period;
  }

  void pass(Stretch whole) {
    const double parts = std::ceil(whole.length / look_), length = whole.length / std::max(parts, 1.);
    for (double i = 0.; i < parts; ++i) {
      Stretch part = whole.after(i * length);
      part.length = length;
      pass_part(part);
    }
  }

  double period() const { return together_.natural_period(); }
  bool stuck() const { return direction_ == 0; }
  const ElasticSliding& result() const { return result_; }

 private:
  /// Goes through a part phase by phase, 8 phases at most; a phase that ends at its very beginning is passed over.
  void pass_part(Stretch part) {
    for (int changes = 0; part.length > 0. && changes < 8; ++changes) {
      const double passed = direction_ == 0 ? stick(part, changes > 0) : slip(part);
      part = part.after(passed);
    }
    note(part.at(0.));
  }

  double shear_stuck(const Motion& at, double P) const { return P - mass_ * together_.acceleration(at, P); }

  double stick(const Stretch& part, bool just_stopped) {
    const auto excess = [&](double t) {
      return std::abs(shear_stuck(together_.after(t, ground_, part.force, part.slope), part.at(t))) - R_;
    };
    double passed = part.length;
    const bool at_once = excess(0.) > 0. && !just_stopped;
    if (at_once)
      passed = 0.;
    else if (excess(part.length) > 0. && excess(0.) <= 0.)
      passed = first_root(excess, part.length);
    ground_ = together_.after(passed, ground_, part.force, part.slope);
    block_v_ = ground_.v;
    const double F_T = shear_stuck(ground_, part.at(passed));
    if (at_once || passed < part.length) begin_slip(F_T > 0. ? 1 : -1, part.start + passed);
    return passed;
  }

  void begin_slip(int direction, double time) {
    direction_ = direction;
    slip_ = {time, time, 0., 0.};
    ground_ = base_.after(0., ground_, direction * R_, 0.);  // a bare spring takes its new position at once
  }

  /// Velocity of the block over its base.
  double relative_speed(const Stretch& part, double t) const {
    const double block = block_v_ + t * (part.force - direction_ * R_ + 0.5 * t * part.slope) / mass_;
    return block - base_.after(t, ground_, direction_ * R_, 0.).v;
  }

  double slip(const Stretch& part) {
    const auto speed = [&](double t) { return direction_ * relative_speed(part, t); };
    double passed = part.length;
    if (speed(part.length) < 0.) passed = speed(0.) > 0. ? first_root(speed, part.length) : 0.;
    const Motion before = ground_;
    const double a = (part.force - direction_ * R_) / mass_, jerk = part.slope / mass_;
    ground_ = base_.after(passed, before, direction_ * R_, 0.);
    slip_.distance += passed * (block_v_ + passed * (a / 2. + passed * jerk / 6.)) - (ground_.x - before.x);
    block_v_ += passed * (a + passed * jerk / 2.);
    if (std::abs(block_v_ - ground_.v) > std::abs(slip_.peak_velocity)) slip_.peak_velocity = block_v_ - ground_.v;
    if (passed < part.length) end_slip(part.start + passed);
    return passed;
  }

  void end_slip(double time) {
    direction_ = 0;
    ground_.v = block_v_;
    slip_.stop = time;
    result_.slip.add(slip_);
  }

  void note(double P) {
    const double F_T = direction_ == 0 ? shear_stuck(ground_, P) : direction_ * R_;
    const double slipped = result_.slip.residual + (direction_ == 0 ? 0. : slip_.distance);
    result_.peak_shear = std::max(result_.peak_shear, std::abs(F_T));
    result_.peak_displacement = std::max(result_.peak_displacement, std::abs(ground_.x + slipped));
  }

  double mass_, R_;
  Oscillator together_, base_;
  double look_;
  int direction_ = 0;    ///< of the slip; 0: stuck
  Motion ground_;        ///< y, y'
  double block_v_ = 0.;  ///< x'
  Slip slip_;
  ElasticSliding result_;
};

void require_sound(double mass, const ElasticBase& base, double resistance) {
  if (!(mass > 0. && base.stiffness > 0. && resistance > 0. && base.mass >= 0. && base.damping >= 0.))
    throw std::invalid_argument("a block on a base needs mass, stiffness and resistance > 0, no negative damping");
  if (base.mass == 0. && base.damping > 0.) throw std::invalid_argument("a base with a dashpot needs a mass");
}

}  // namespace

ElasticSliding slide_on_base(double mass, const ElasticBase& base, const History& force, double resistance) {
  require_sound(mass, base, resistance);
  BlockOnBase block(mass, base, resistance);
  double end = 0.;
  for (const LinearPiece& piece : force_pieces(force, {{0.}, {resistance}})) {
    block.pass({piece.start, piece.length, piece.first.begin, (piece.first.end - piece.first.begin) / piece.length});
    end = piece.start + piece.length;
  }
  // P is over, but the caisson may slip on, or slip again, for some periods
  for (int quiet = 0; quiet < 3; end += block.period()) {
    const std::size_t slips = block.result().slip.slips.size();
    block.pass({end, block.period(), 0., 0.});
    quiet = block.stuck() && block.result().slip.slips.size() == slips ? quiet + 1 : 0;
  }
  return block.result();
}

}  // namespace upbead
