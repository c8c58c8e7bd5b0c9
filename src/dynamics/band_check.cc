#include "dynamics/band_check.h"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "base/numbers.h"
#include "phi_functions.h"
#include "real_fft.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

/// Response at the samples' times to the lines between samples exp(i omega n h), of load k: what the recurrence of
/// every mode does to them.
Complex sampled_transfer(const ModalModel& model, int i, int k, double omega, double h) {
  const Complex Z = std::polar(1., omega * h);
  const auto mode = [&](const Complex& pole) {
    const detail::PhiFunctions phi = detail::phi_functions(pole * h);
    return h * (phi.phi1 + (Z - 1.) * phi.phi2) / (Z - phi.exp);
  };
  Complex H = model.feedthrough(i, k);
  if (model.impulse(i, k) != 0.) H += model.impulse(i, k) * mode(0.);
  for (int m = 0; m < model.n_modes(); ++m) {
    const Complex product = model.reading(i, m) * model.load(m, k);
    H += 0.5 * (product * mode(model.pole[m]) + std::conj(product) * mode(std::conj(model.pole[m])));
  }
  return H;
}

/// The part of sampled_transfer() from beyond `limit`. Lines between samples hold omega and all omega + 2 pi j / h,
/// each with the spectrum sinc^2 of the hat that a sample makes of them, and at the samples' times all look like omega.
/// Below the limit, what omega itself brings is taken off; the rest is what the corners of the lines bring.
Complex transfer_beyond(const ModalModel& model, int i, int k, double omega, double h, double limit) {
  if (omega == 0.) return 0.;  // lines between equal samples have no corners
  const Complex all = sampled_transfer(model, i, k, omega, h);
  if (omega > limit) return all;
  const double half = 0.5 * omega * h, sinc = std::sin(half) / half;
  return all - sinc * sinc * model.transfer(i, k, Complex(0., omega));
}

}  // namespace

BandCheck::BandCheck(const ModalModel& model, int reading, double step, int n, double omega)
    : n_(n), fft_(std::make_shared<const detail::RealFft>(2 * n)), transfer_(fft_->size() / 2 + 1, model.n_loads()) {
  for (Eigen::Index k = 0; k < transfer_.cols(); ++k)
    for (Eigen::Index j = 0; j < transfer_.rows(); ++j) {
      const double at = 2. * pi * static_cast<double>(j) / (static_cast<double>(fft_->size()) * step);
      transfer_(j, k) = transfer_beyond(model, reading, static_cast<int>(k), at, step, omega);
    }
}

double BandCheck::beyond(const Eigen::Ref<const WaveSamples>& loads) const {
  if (loads.rows() != transfer_.cols() || loads.cols() != n_)
    throw std::invalid_argument("a wave's loads do not fit the reduced model or its check");
  Eigen::VectorXcd y = Eigen::VectorXcd::Zero(transfer_.rows());
  for (Eigen::Index k = 0; k < loads.rows(); ++k)
    y.array() += transfer_.col(k).array() * fft_->forward(loads.row(k).transpose()).array();
  return fft_->backward(y).cwiseAbs().maxCoeff();
}

}  // namespace upbead
