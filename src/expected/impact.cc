#include "expected/impact.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>

#include "base/constants.h"

namespace upbead {

namespace {

template <class Function>
double root(const Function& f, double from, double to) {
  boost::uintmax_t most = 60;
  const auto bracket =
      boost::math::tools::toms748_solve(f, from, to, boost::math::tools::eps_tolerance<double>(40), most);
  return 0.5 * (bracket.first + bracket.second);
}

double triangle(const ImpactWave& wave, double t) {
  if (t <= wave.rise) return wave.peak * t / wave.rise;
  return t < wave.duration ? wave.peak * (wave.duration - t) / (wave.duration - wave.rise) : 0.;
}

/// Impulse of max(gamma P_1 sin(omega t), triangle) over half a period. Between 0 and t_r and between t_r and t_d the
/// triangle less the sine is convex, it is 0 at 0, not negative at t_r and not positive at t_d: it changes its sign at
/// most once on each flank.
double impulse(const ImpactWave& wave, double gamma) {
  const double omega = 2. * pi / wave.period, peak = gamma * wave.standing_force;
  const auto excess = [&](double t) { return triangle(wave, t) - peak * std::sin(omega * t); };
  const double rise = wave.rise, end = wave.duration;
  const double early = 1e-6 * rise;
  const double t1 = excess(early) < 0. ? root(excess, early, rise) : 0.;
  const double t2 = excess(end) < 0. ? root(excess, rise, end) : end;
  const double sine = peak / omega * (2. - (std::cos(omega * t1) - std::cos(omega * t2)));
  const double up = 0.5 * wave.peak / rise * (rise * rise - t1 * t1);
  const double down = 0.5 * wave.peak / (end - rise) * (std::pow(end - rise, 2) - std::pow(end - t2, 2));
  return sine + up + down;
}

double reduction(const ImpactWave& wave) {
  const double whole = wave.standing_force * wave.period / pi;
  const auto excess = [&](double gamma) { return impulse(wave, gamma) - whole; };
  if (excess(0.) >= 0.) return 0.;
  if (excess(1.) <= 0.) return 1.;
  return root(excess, 0., 1.);
}

/// sin(n angle) for n = 0, 1, 2 ... by turning a vector; it drifts by some 1e-13 in a thousand turns.
class Sines {
 public:
  explicit Sines(double angle) : turn_(std::polar(1., angle)) {}
  double next() {
    const double sine = at_.imag();
    at_ = {at_.real() * turn_.real() - at_.imag() * turn_.imag(),
           at_.real() * turn_.imag() + at_.imag() * turn_.real()};
    return sine;
  }

 private:
  std::complex<double> turn_, at_{1., 0.};
};

}  // namespace

ImpactWave impact_wave(const ImpactAssumptions& a, const WaveOnWall& on_wall, const Water& water, double berm_depth) {
  const double g = water.gravity, T = on_wall.period;
  ImpactWave wave;
  wave.period = T;
  wave.standing_force = on_wall.standing_force;
  wave.peak = on_wall.standing_force * (1. + a.peak_gain * on_wall.alpha_star);
  wave.uplift = on_wall.uplift;
  const double relative_peak = wave.peak / (water.density * g * on_wall.height * on_wall.height);  // F*
  const double rise = a.rise_coefficient * std::sqrt(berm_depth / g) / relative_peak;
  const double duration = rise * (a.duration_least + a.duration_gain * std::exp(-a.duration_decay * rise / T));
  wave.duration = std::min(duration, 0.5 * T);
  wave.rise = std::min(rise, 0.5 * wave.duration);
  wave.reduction = reduction(wave);
  return wave;
}

ForceLimits limits(const ImpactWave& wave) {
  const double standing = wave.reduction * wave.standing_force, sine = standing * 2. * pi / wave.period;
  return {std::max(wave.peak, standing), wave.rise, std::max(wave.peak / wave.rise, sine),
          std::max(wave.peak / (wave.duration - wave.rise), sine)};
}

int number_of_samples(const ImpactWave& wave, double step) {
  return static_cast<int>(std::ceil(0.5 * wave.period / step)) + 1;
}

void sample_force(const ImpactWave& wave, double step, int n, double* force) {
  Sines sines(2. * pi * step / wave.period);
  const double standing = wave.reduction * wave.standing_force;
  for (int i = 0; i < n; ++i) force[i] = std::max({standing * sines.next(), triangle(wave, i * step), 0.});
}

void sample_uplift(const ImpactWave& wave, ImpactUplift shape, double step, int n, const double* force,
                   double* uplift) {
  Sines sines(2. * pi * step / wave.period);
  const double largest = std::max(wave.peak, wave.reduction * wave.standing_force);
  for (int i = 0; i < n; ++i) {
    const double sine = std::max(sines.next(), 0.);
    if (shape == ImpactUplift::in_phase)
      uplift[i] = wave.uplift * force[i] / largest;
    else if (shape == ImpactUplift::held && i * step <= 0.25 * wave.period)
      uplift[i] = wave.uplift;
    else
      uplift[i] = wave.uplift * sine;
  }
}

}  // namespace upbead
