#include "response/carried_pulse.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "base/numbers.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

/// z h of generalised-alpha: -z^2 d = a, with v and d updated by Newmark's formulas.
Complex of_alpha(Complex w) {
  constexpr double rho = 0.9, m = (2. * rho - 1.) / (rho + 1.), f = rho / (rho + 1.), gamma = 0.5 - m + f,
                   beta = 0.25 * (1. - m + f) * (1. - m + f);
  const Complex q = std::exp(w), moved = (1. - gamma) + gamma * q + (q - 1.) * (0.5 - beta + beta * q);
  const Complex square = ((1. - m) * q + m) * (q - 1.) * (q - 1.) / (((1. - f) * q + f) * moved);
  const Complex root = std::sqrt(square);
  return std::real(root * std::conj(w)) < 0. ? -root : root;
}

}  // namespace

bool SteppedFrequency::feels(Complex s) const {
  return s.imag() * steps_.size <= boost::math::constants::pi<double>();
}

Complex SteppedFrequency::operator()(Complex s) {
  if (steps_.size == 0.) return s;
  const Complex w = s * steps_.size;
  return (steps_.order == 2 ? of_alpha(w) : of_sdirk4(w)) / steps_.size;
}

Complex SteppedFrequency::of_sdirk4(Complex w) {
  Complex z = last_z_ + w - last_w_;
  const Complex aim = std::exp(w);
  for (int i = 0; i < 20; ++i) {
    const Complex base = 1. - 0.25 * z, below = std::pow(base, 5);
    const Complex above = 1. + z * (-0.25 + z * (-0.125 + z * (1. / 96. + z * 7. / 768.)));
    const Complex slope = -0.25 + z * (-0.25 + z * (1. / 32. + z * 7. / 192.));
    const Complex R = above / below, change = (R - aim) / (slope / below + 1.25 * R / base);
    z -= change;
    if (std::abs(change) < 1e-12) break;
  }
  last_w_ = w;
  last_z_ = z;
  return z;
}

namespace {

using Complex = std::complex<double>;

constexpr double most_cells = 400., tail = 30.;      ///< the longest way of a wave and its tail, in cells
constexpr double highest = 8., steps_per_cell = 4.;  ///< highest omega h/c, and times per crossing of a cell
/// Highest omega times the duration: above omega a triangle has less than 8 / (pi omega duration) of its peak, 0.4 %.
constexpr double highest_of_load = 600.;
constexpr double fall = 1e-3;  ///< factor on what returns after the Fourier series' period

/// The root lambda with which exp(-lambda x) decays.
Complex wave_number(Complex square) {
  const Complex lambda = std::sqrt(square);
  return lambda.real() < 0. ? -lambda : lambda;
}

/// Laplace transform of the triangle, or of the jump where the duration is 0.
Complex transform(double duration, Complex s) {
  if (duration <= 0.) return 1. / s;
  const Complex half = std::exp(-0.5 * s * duration);
  return (1. - half) * (1. - half) / (0.5 * s * s * duration);
}

/// The difference between the wave in finite elements and the exact one, at one place, over time.
class Difference {
 public:
  Difference(const WaveLaw& law, double duration, const WaveCells& cells, double speed, double distance)
      : law_(law), duration_(duration), cells_(cells), n_cells_(std::max(1., std::round(distance / cells.size))) {
    const double crossing = cells.size / speed;
    const double last = duration > 0. ? std::min(highest / crossing, highest_of_load / duration) : highest / crossing;
    time_ = 1.5 * ((n_cells_ + tail) * crossing + duration);
    damping_ = -std::log(fall) / (2. * time_);
    n_frequencies_ = static_cast<std::size_t>(std::ceil(last * time_ / pi));
    const double n_times =
        std::max(2. * steps_per_cell / highest * last * time_, 2. * static_cast<double>(n_frequencies_));
    n_times_ = static_cast<std::size_t>(std::exp2(std::ceil(std::log2(n_times))));
  }

  /// The Fourier series has the period 2 T. The error of cutting it off grows towards the end, so only its first
  /// third is used.
  double largest() const {
    std::vector<Complex> amplitude(n_times_), value;
    SteppedFrequency felt(cells_.steps);
    for (std::size_t j = 0; j < n_frequencies_; ++j)
      amplitude[j] = (j == 0 ? 0.5 : 1.) * transformed({damping_, static_cast<double>(j) * pi / time_}, felt);
    Eigen::FFT<double> series;
    series.SetFlag(Eigen::FFT<double>::Unscaled);
    series.inv(value, amplitude);
    double largest = 0.;
    for (std::size_t i = 0; i <= n_times_ / 3; ++i) {
      const double t = 2. * time_ * static_cast<double>(i) / static_cast<double>(n_times_);
      largest = std::max(largest, std::abs(std::exp(damping_ * t) * value[i].real() / time_));
    }
    return largest;
  }

 private:
  Complex transformed(Complex s, SteppedFrequency& felt) const {
    const Complex exact = std::exp(-wave_number(law_(s)) * n_cells_ * cells_.size);
    const Complex found = felt.feels(s) ? std::pow(carried_over_cell(law_(felt(s)), cells_), n_cells_) : Complex(0.);
    return transform(duration_, s) * (found - exact);
  }

  const WaveLaw& law_;
  double duration_;
  WaveCells cells_;
  double n_cells_, time_ = 0., damping_ = 0.;
  std::size_t n_frequencies_ = 0, n_times_ = 0;
};

}  // namespace

Complex carried_over_cell(Complex square, const WaveCells& cells) {
  const Complex z = -square * cells.size * cells.size;
  const Complex cosine = cells.degree == 1 ? (6. - 2. * z) / (6. + z)
                         : cells.degree == 2
                             ? (240. + z * (-104. + 3. * z)) / (240. + z * (16. + z))
                             : (25200. + z * (-11520. + z * (540. - 4. * z))) / (25200. + z * (1080. + z * (30. + z)));
  const Complex root = std::sqrt(cosine * cosine - 1.);
  return std::abs(cosine + root) < std::abs(cosine - root) ? cosine + root : cosine - root;
}

double carried_speed(const WaveLaw& law, double duration, const WaveCells& cells) {
  double speed = 0., omega = pi / duration;
  if (!(duration > 0.)) {  // a jump: the wave to which a cell is a radian long; its speed is found by iteration
    const Complex first = wave_number(law(Complex(0., 1.)));
    omega = std::abs(first) > 0. ? 1. / (std::abs(first) * cells.size) : 0.;
  }
  for (int turn = 0; turn < 4 && omega > 0.; ++turn) {
    const Complex lambda = wave_number(law(Complex(0., omega)));
    speed = std::abs(lambda) > 0. ? omega / std::abs(lambda) : 0.;
    if (duration > 0. || speed == 0.) break;
    omega = speed / cells.size;
  }
  return speed;
}

double carried_error(const WaveLaw& law, double duration, const WaveCells& cells, double least, double most) {
  const double speed = carried_speed(law, duration, cells);
  if (speed == 0. || !std::isfinite(speed)) return 0.;
  const double last = std::min(most, most_cells * cells.size);
  double largest = 0.;
  for (double distance = std::min(std::max(least, cells.size), last);; distance = std::min(4. * distance, last)) {
    largest = std::max(largest, Difference(law, duration, cells, speed, distance).largest());
    if (distance >= last) return largest;
  }
}

}  // namespace upbead
