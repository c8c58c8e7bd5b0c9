// The error of finite elements and time steps in a plane wave.
#pragma once

#include <complex>
#include <functional>

namespace upbead {

/// Equal steps of a time scheme; of size 0 where there are no steps (a reduced model).
struct WaveSteps {
  double size = 0.;  ///< s
  int order = 4;     ///< 4: sdirk4, 2: generalised_alpha
};

/// The frequency z that a time scheme gives in place of s: where the exact solution of the system is exp(z t), the
/// scheme gives exp(s t) with s != z. To be called for ascending frequencies, as the root is followed from one to the
/// next. sdirk4: R(z h) = exp(s h) by Newton's method, R(z) = (1 - z/4 - z^2/8 + z^3/96 + 7 z^4/768)/(1 - z/4)^5
/// (from the tableau IV.6.5 in Hairer and Wanner 1996); generalised_alpha (Chung and Hulbert 1993, rho_inf = 0.9):
/// its equations for d, v, a ~ q^n, q = exp(s h), solved for z^2 without damping. Beyond pi/h the steps carry no
/// wave.
class SteppedFrequency {
 public:
  explicit SteppedFrequency(const WaveSteps& steps) : steps_(steps) {}
  bool feels(std::complex<double> s) const;
  std::complex<double> operator()(std::complex<double> s);

 private:
  std::complex<double> of_sdirk4(std::complex<double> w);

  WaveSteps steps_;
  std::complex<double> last_w_ = 0., last_z_ = 0.;
};

/// Square of lambda in exp(s t - lambda x) at a complex frequency s (1/s): model/plane_waves.h.
using WaveLaw = std::function<std::complex<double>(std::complex<double> s)>;

/// The cells and time steps that carry a wave.
struct WaveCells {
  double size = 0.;  ///< h, along the wave (m)
  int degree = 1;    ///< of the field that carries it: u, or for the slow wave the pressure; 1 to 3
  WaveSteps steps;
};

/// The factor exp(-lambda h) from one node to the next where lambda^2 = `square`, as elements with exact integrals
/// give it; of both roots the one that decays. With z = -lambda^2 h^2 [Ainsworth 2004: cos(k h) is replaced by its
/// Pade approximant]
///   degree 1  (6 - 2 z)/(6 + z)
///   degree 2  (240 - 104 z + 3 z^2)/(240 + 16 z + z^2)
///   degree 3  (25200 - 11520 z + 540 z^2 - 4 z^3)/(25200 + 1080 z + 30 z^2 + z^3).
std::complex<double> carried_over_cell(std::complex<double> square, const WaveCells& cells);

/// The error of a load that enters at x = 0 and is carried on: the largest difference between the wave in cells and
/// steps and the exact wave, at any time and node from x = `least` to x = `most` (m), over the load's largest value.
/// It is the error of a stress, a pressure or a velocity. The load is a symmetric triangle of that duration (s; 0: a
/// jump that stays). By the Laplace transform, inverted as a Fourier series with damping [Crump 1976]. 0 where the
/// law has no wave; the wave is followed for at most 400 cells.
double carried_error(const WaveLaw& law, double duration, const WaveCells& cells, double least, double most);

/// Speed of the part of the load that the cells resolve (m/s): at omega = pi over the duration; for a jump at the
/// omega at which a cell is a radian long; 0 without a wave.
double carried_speed(const WaveLaw& law, double duration, const WaveCells& cells);

}  // namespace upbead
