// One mass on a spring and a dashpot under a force that runs along a straight line.
#pragma once

#include <complex>

namespace upbead::detail {

/// Displacement and velocity.
struct Motion {
  double x = 0., v = 0.;
};

/// Solves mass x'' + damping x' + stiffness x = force, exactly. Without mass it is a bare spring: damping must be 0.
class Oscillator {
 public:
  Oscillator(double mass, double damping, double stiffness);
  /// After t seconds from `start` under force + slope t.
  Motion after(double t, const Motion& start, double force, double slope) const;
  double acceleration(const Motion& at, double force) const;
  double natural_period() const;  ///< 2 pi sqrt(mass/stiffness); 0 without mass (s)

 private:
  double mass_, damping_, stiffness_;
  std::complex<double> root_[2];  ///< of mass s^2 + damping s + stiffness
};

}  // namespace upbead::detail
