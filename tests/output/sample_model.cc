#include "sample_model.h"

#include <cmath>

namespace upbead::test {

ReducedModelFile oscillator() {
  using Complex = std::complex<double>;
  const double mass = 604.8e3, rate = 4. * std::acos(-1.), ratio = 0.15;
  const Complex pole(-ratio * rate, rate * std::sqrt(1. - ratio * ratio));
  const Complex x(0., -1. / (mass * pole.imag()));  // x = Re (x z), the impulse response exp(-a t) sin(b t) / (m b)
  ReducedModelFile model;
  model.title = "oscillator";
  model.case_text = "title = \"oscillator\"\n";
  ModalModel& modes = model.modes;
  modes.pole = Eigen::Vector2cd(pole, Complex(-60., 200.));
  modes.load = Eigen::MatrixXcd::Ones(2, 2);
  modes.reading.setZero(3, 2);
  modes.reading.row(1) << mass * (rate * rate + 2. * ratio * rate * pole) * x, Complex(0.5, -1.);
  modes.reading(2, 0) = x;
  modes.feedthrough.setZero(3, 2);
  modes.feedthrough.row(0).setOnes();
  modes.impulse.setZero(3, 2);
  modes.load_name = {"impact", "slow"};
  modes.reading_label = {{"force", "N/m", "P"}, {"shear_force", "N/m", "F_T"}, {"caisson/displacement_x", "m", "x_G"}};
  model.loads = {{"impact", "N/m", 1.6e6, 0.15}, {"slow", "N/m", 4e5, 3.}};
  model.caisson_mass = mass;
  model.end = 4.;
  model.highest_frequency = 50.;
  model.tolerance = 0.01;
  model.error = 0.004;
  model.error_peak = 0.003;
  model.error_march = 0.002;
  model.unknowns = 12345;
  model.solves = 20;
  model.factorisations = 2;
  return model;
}

}  // namespace upbead::test
