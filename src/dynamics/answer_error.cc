#include "dynamics/answer_error.h"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "base/numbers.h"
#include "dynamics/phi_functions.h"
#include "dynamics/real_fft.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

constexpr double padding = 1.1;  ///< length of the FFT over that of the wave
constexpr double wrapped = 10.;  ///< what wraps around falls by exp(-wrapped)
/// The bound's safety on both differences, see docs/reduced.md.
constexpr double safety_of_model = 1.2, safety_of_middle = 1.5;

/// Z - 1 at the frequencies of the FFT.
Eigen::ArrayXcd contour(Eigen::Index n_fft) {
  const double n = static_cast<double>(n_fft);
  Eigen::ArrayXcd q(n_fft / 2 + 1);
  for (Eigen::Index j = 0; j < q.size(); ++j)
    q[j] = std::exp(Complex(wrapped, 2. * pi * static_cast<double>(j)) / n) - 1.;
  return q;
}

/// Sampled transfer function of load k at the contour. With q = Z - 1 and g = E - 1 a pair of conjugate poles gives
/// Re-coefficients over (q - g) (q - conj g), all without cancellation where steps are short beside the poles.
Eigen::VectorXcd sampled_transfer(const ModalModel& model, int i, int k, double h, const Eigen::ArrayXcd& q) {
  Eigen::ArrayXcd H = Eigen::ArrayXcd::Constant(q.size(), model.feedthrough(i, k));
  if (model.impulse(i, k) != 0.) H += model.impulse(i, k) * h * (1. + 0.5 * q) / q;
  for (int m = 0; m < model.n_modes(); ++m) {
    const Complex residue = model.reading(i, m) * model.load(m, k);
    if (residue == 0.) continue;
    const detail::PhiFunctions phi = detail::phi_functions(model.pole[m] * h);
    const Complex g = model.pole[m] * h * phi.phi1, u = residue * h * phi.phi1, v = residue * h * phi.phi2;
    const double a2 = v.real(), a1 = (u - v * std::conj(g)).real(), a0 = -(u * std::conj(g)).real();
    H += ((a2 * q + a1) * q + a0) / ((q - g) * (q - std::conj(g)));
  }
  return H;
}

}  // namespace

double ResponseDifference::bound() const {
  return safety_of_model * of_model.cwiseAbs().maxCoeff() + safety_of_middle * of_middle.cwiseAbs().maxCoeff();
}

ResponseError::ResponseError(const ModalModel& model, int reading, const NestedModels& nested, double step, int n)
    : n_(n),
      fft_(std::make_shared<const detail::RealFft>(static_cast<Eigen::Index>(padding * n) + 1)),
      weight_(n),
      of_model_(fft_->size() / 2 + 1, model.n_loads()),
      of_middle_(of_model_.rows(), of_model_.cols()) {
  for (Eigen::Index j = 0; j < n; ++j)
    weight_[j] = std::exp(-wrapped * static_cast<double>(j) / static_cast<double>(fft_->size()));
  const Eigen::ArrayXcd q = contour(fft_->size());
  for (int k = 0; k < model.n_loads(); ++k) {
    const Eigen::VectorXcd reference = sampled_transfer(nested.reference, 0, k, step, q);
    of_model_.col(k) = reference - sampled_transfer(model, reading, k, step, q);
    of_middle_.col(k) = reference - sampled_transfer(nested.middle, 0, k, step, q);
  }
}

ResponseDifference ResponseError::of(const Eigen::Ref<const WaveSamples>& loads) const {
  if (loads.rows() != of_model_.cols() || loads.cols() != n_)
    throw std::invalid_argument("a wave's loads do not fit the reduced model or its check");
  Eigen::VectorXcd model = Eigen::VectorXcd::Zero(of_model_.rows()), middle = model;
  for (Eigen::Index k = 0; k < loads.rows(); ++k) {
    if (loads.row(k).isZero(0.)) continue;
    const Eigen::VectorXcd F = fft_->forward(loads.row(k).transpose().cwiseProduct(weight_));
    model += of_model_.col(k).cwiseProduct(F);
    middle += of_middle_.col(k).cwiseProduct(F);
  }
  const auto in_time = [this](Eigen::VectorXcd& amplitude) -> Eigen::VectorXd {
    return fft_->backward(std::move(amplitude)).head(n_).cwiseQuotient(weight_);
  };
  return {in_time(model), in_time(middle)};
}

namespace {

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
