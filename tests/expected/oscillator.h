// A caisson on a spring and a dashpot as a model of F_T.
#pragma once

#include <cmath>
#include <complex>

#include "caissons.h"
#include "expected/dynamic_law.h"

namespace upbead::test {

/// A mass on a spring and a dashpot under the load `impact` in MN/m: F_T = c x' + k x.
inline ShearModel oscillator(double frequency, double ratio) {
  using Complex = std::complex<double>;
  const double mass = medium_caisson().section.weight / 9.81, rate = 2. * std::acos(-1.) * frequency;
  const Complex pole(-ratio * rate, rate * std::sqrt(1. - ratio * ratio));
  const Complex x = Complex(0., -1. / (mass * pole.imag()));
  ShearModel model;
  model.modes.pole = Eigen::VectorXcd::Constant(1, pole);
  model.modes.load = Eigen::MatrixXcd::Constant(1, 1, 1e6);
  model.modes.reading = Eigen::MatrixXcd::Constant(1, 1, mass * (rate * rate + 2. * ratio * rate * pole) * x);
  model.modes.feedthrough = model.modes.impulse = Eigen::MatrixXd::Zero(1, 1);
  model.modes.load_name = {"impact"};
  model.modes.reading_label = {{"shear_force", "N/m", "F_T"}};
  model.force_per_load = 1e6;
  model.caisson_mass = mass;
  return model;
}

}  // namespace upbead::test
