#include "upbead/sliding/combined.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/numbers.h"
#include "base/root.h"

namespace upbead {

namespace {

constexpr int points_of_half_period = 400;  // chords lie below the sine by up to 8e-6 of its height

template <class Function>
double root(const Function& f, double from, double to, int bits) {
  const auto bracket = root_bracket(f, from, to, bits);
  return 0.5 * (bracket.first + bracket.second);
}

/// P_1 with a given gamma_P, P_2, and the interval t_1 to t_2 on which P_2 is the larger one. There is at most one: on
/// both flanks of the triangle P_2 - P_1 is convex, it is 0 at t = 0 and not positive at tau_0.
class Parts {
 public:
  Parts(const CombinedWave& wave, double gamma)
      : omega_(2. * pi / wave.period),
        peak_(gamma * wave.standing_force),
        pulse_(wave.impulsive),
        half_(0.5 * wave.impulsive.duration) {
    const auto excess = [this](double t) { return triangle(t) - standing(t); };
    if (excess(half_) <= 0.) return;
    const bool from_start = pulse_.peak / half_ >= peak_ * omega_;
    // just above 0, where the sine rises faster, the difference is negative
    t1_ = from_start ? 0. : root(excess, 1e-9 * half_, half_, 50);
    t2_ = excess(pulse_.duration) < 0. ? root(excess, half_, pulse_.duration, 50) : pulse_.duration;
  }

  double standing(double t) const { return omega_ * t < pi ? peak_ * std::sin(omega_ * t) : 0.; }
  double triangle(double t) const {
    return t < pulse_.duration ? pulse_.peak * (1. - std::abs(t - half_) / half_) : 0.;
  }
  double force(double t) const { return std::max(standing(t), triangle(t)); }
  /// Largest P, 0 where there is no force.
  double largest() const { return std::max(peak_, pulse_.peak); }
  double t1() const { return t1_; }
  double t2() const { return t2_; }

  /// Impulse of P = max(P_1, P_2).
  double impulse() const {
    const double sine = peak_ / omega_ * (2. - (std::cos(omega_ * t1_) - std::cos(omega_ * t2_)));
    const double rise = 0.5 * pulse_.peak / half_ * (half_ * half_ - t1_ * t1_);
    const double rest = pulse_.duration - t2_;
    const double fall = 0.5 * pulse_.peak / half_ * (half_ * half_ - rest * rest);
    return t2_ > t1_ ? sine + rise + fall : 2. * peak_ / omega_;
  }

 private:
  double omega_, peak_;
  TriangularPulse pulse_;
  double half_;
  double t1_ = 0., t2_ = 0.;
};

void require_sound(const CombinedWave& wave) {
  if (!(wave.period > 0. && wave.standing_force >= 0. && wave.uplift >= 0. && wave.impulsive.peak >= 0. &&
        wave.impulsive.duration > 0. && wave.impulsive.duration <= 0.5 * wave.period))
    throw std::invalid_argument(
        "a combined wave needs period > 0, peak, standing force and uplift >= 0, and 0 < tau_0 <= T/2");
}

std::vector<double> times_of(const CombinedWave& wave, const Parts& parts) {
  std::vector<double> times{0.5 * wave.impulsive.duration, wave.impulsive.duration, parts.t1(), parts.t2()};
  for (int i = 0; i <= points_of_half_period; ++i) times.push_back(0.5 * wave.period * i / points_of_half_period);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

double uplift_at(const CombinedWave& wave, const CombinedModel& model, const Parts& parts, double t) {
  if (model.uplift == UpliftShape::in_phase)
    return parts.largest() > 0. ? wave.uplift * parts.force(t) / parts.largest() : 0.;
  return 2. * t < wave.period ? model.uplift_gain * wave.uplift * std::sin(2. * pi * t / wave.period) : 0.;
}

/// A quantity of the wave at all points.
template <class Value>
History history_of(const CombinedWave& wave, const Value& value) {
  const Parts parts(wave, standing_reduction(wave));
  History history{times_of(wave, parts), {}};
  for (const double t : history.time) history.value.push_back(value(parts, t));
  return history;
}

}  // namespace

double standing_reduction(const CombinedWave& wave) {
  require_sound(wave);
  const double whole = wave.standing_force * wave.period / pi;
  const auto excess = [&](double gamma) { return Parts(wave, gamma).impulse() - whole; };
  if (excess(0.) >= 0.) return 0.;
  if (excess(1.) <= 0.) return 1.;
  return root(excess, 0., 1., 40);
}

History combined_force(const CombinedWave& wave) {
  return history_of(wave, [](const Parts& parts, double t) { return parts.force(t); });
}

History combined_uplift(const CombinedWave& wave, const CombinedModel& model) {
  return history_of(wave, [&](const Parts& parts, double t) { return uplift_at(wave, model, parts, t); });
}

double added_mass(double density, double foundation_depth, const CombinedModel& model) {
  return model.added_mass_factor * density * foundation_depth * foundation_depth;
}

double sliding_distance_combined(double mass, double resistance, double friction, const CombinedWave& wave,
                                 const CombinedModel& model) {
  require_sound(wave);
  const double peak = std::max(wave.impulsive.peak, wave.standing_force);
  const double uplift = wave.uplift * std::max(model.uplift_gain, 1.);
  if (peak + friction * uplift <= resistance) return 0.;  // most waves end here
  const History F_S = history_of(
      wave, [&](const Parts& parts, double t) { return parts.force(t) + friction * uplift_at(wave, model, parts, t); });
  return slide(mass, F_S, resistance).residual;
}

}  // namespace upbead
