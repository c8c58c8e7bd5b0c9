// The frequency that a scene feels when it is marched in steps.
#pragma once

#include <complex>

namespace upbead {

/// Equal steps of a time scheme; of size 0 where time has none (a reduced model).
struct WaveSteps {
  double size = 0.;  ///< s
  int order = 4;     ///< 4: sdirk4, 2: generalised_alpha
};

/// What the scheme makes of s: where the system is solved by exp(z t), the scheme gives exp(s t) with s != z. Asked for
/// ascending frequencies, as the root is followed from one to the next. sdirk4: R(z h) = exp(s h) by Newton's method,
///   R(z) = (1 - z/4 - z^2/8 + z^3/96 + 7 z^4/768)/(1 - z/4)^5  (of the tableau IV.6.5 in Hairer and Wanner 1996);
/// generalised_alpha (Chung and Hulbert 1993, rho_inf = 0.9): its equations for d, v, a ~ q^n, q = exp(s h), solved for
/// z^2 without damping. Beyond pi/h there is nothing to be felt.
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

}  // namespace upbead
