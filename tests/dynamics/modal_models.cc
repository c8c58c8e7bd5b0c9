#include "modal_models.h"

#include <cmath>
#include <random>

namespace upbead::test {

namespace {

using Complex = std::complex<double>;
constexpr double pi = 3.14159265358979323846;

ModalModel empty_model(int n_modes, int n_loads, int n_readings) {
  ModalModel model;
  model.pole = Eigen::VectorXcd::Zero(n_modes);
  model.load = Eigen::MatrixXcd::Ones(n_modes, n_loads);
  model.reading = Eigen::MatrixXcd::Ones(n_readings, n_modes);
  model.feedthrough = Eigen::MatrixXd::Zero(n_readings, n_loads);
  model.impulse = Eigen::MatrixXd::Zero(n_readings, n_loads);
  return model;
}

Complex random_pole(int m, double step, double random, double other) {
  switch (m % 6) {
    case 0:
      return -std::pow(10., 2. + random) / step * 1e-2;
    case 1:
      return {0., std::abs(other) / step};
    case 2:
      return m == 2 ? Complex(0.) : Complex(-1e6 / step);
    case 3:
      return m == 3 ? Complex(0., 2. * pi / step) : Complex(-1e-3 / step, 6. / step);
    default:
      return Complex(-std::pow(10., -2. + random), 3. * other) / step;
  }
}

}  // namespace

Complex Oscillator::pole() const {
  const double decay = c / (2. * m);
  return {-decay, std::sqrt(k / m - decay * decay)};
}

ModalModel Oscillator::model() const {
  ModalModel model = empty_model(1, 1, 3);
  model.pole[0] = pole();
  const Complex residue = 1. / (m * Complex(0., 2. * pole().imag()));
  model.reading << 2. * residue, 2. * residue * pole(), 2. * residue * pole() * pole();
  model.feedthrough(2, 0) = 1. / m;
  return model;
}

double Oscillator::impulse_response(double t) const {
  return std::exp(pole().real() * t) * std::sin(pole().imag() * t) / (m * pole().imag());
}

double Oscillator::step_response(double t) const {
  const double decay = -pole().real(), w = pole().imag();
  return (1. - std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t))) / k;
}

ModalModel single_mode(Complex pole) {
  ModalModel model = empty_model(1, 1, 1);
  model.pole[0] = pole;
  return model;
}

ModalModel random_model(int n_modes, int n_loads, int n_readings, double step) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1., 1.);
  const auto complex = [&] { return Complex(number(generator), number(generator)); };
  ModalModel model = empty_model(n_modes, n_loads, n_readings);
  for (int m = 0; m < n_modes; ++m) {
    model.pole[m] = random_pole(m, step, number(generator), number(generator));
    // A unit response of order 1 to a unit load, whatever the pole.
    const double scale = std::min(1. / step, std::abs(model.pole[m]) + 0.01 / step);
    const bool is_real = model.pole[m].imag() == 0.;
    for (int k = 0; k < n_loads; ++k)
      model.load(m, k) = (m + k) % 5 == 4 ? 0. : scale * (is_real ? Complex(number(generator)) : complex());
    for (int i = 0; i < n_readings; ++i) model.reading(i, m) = is_real ? Complex(number(generator)) : complex();
  }
  for (int i = 0; i < n_readings; ++i)
    for (int k = 0; k < n_loads; ++k) {
      model.feedthrough(i, k) = number(generator);
      model.impulse(i, k) = 0.01 / step * number(generator);
    }
  return model;
}

}  // namespace upbead::test
