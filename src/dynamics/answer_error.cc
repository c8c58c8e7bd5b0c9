#include "dynamics/answer_error.h"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "base/numbers.h"
#include "dynamics/lanes.h"
#include "dynamics/phi_functions.h"
#include "dynamics/real_fft.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

constexpr double safety_of_model = 1.2;  ///< on the difference between reference and model: docs/reduced.md
constexpr double padding = 1.1;          ///< length of the FFT over that of the wave
constexpr double wrapped = 10.;          ///< parts that wrap around are damped by exp(-wrapped)

/// Z - 1 at the frequencies of the FFT.
Eigen::ArrayXcd contour(Eigen::Index n_fft) {
  const double n = static_cast<double>(n_fft);
  Eigen::ArrayXcd q(n_fft / 2 + 1);
  for (Eigen::Index j = 0; j < q.size(); ++j)
    q[j] = std::exp(Complex(wrapped, 2. * pi * static_cast<double>(j)) / n) - 1.;
  return q;
}

/// Sum of the terms of conjugate pairs of poles in a transfer function, by real and imaginary part.
struct Sums {
  explicit Sums(Eigen::Index n) : re(Eigen::ArrayXd::Zero(n)), im(Eigen::ArrayXd::Zero(n)) {}
  Eigen::VectorXcd complex() const { return re.matrix() + Complex(0., 1.) * im.matrix(); }
  Eigen::ArrayXd re, im;
};

/// The sampled term of a pair of poles: (a2 q^2 + a1 q + a0) / ((q - g) (q - conj g)).
struct SampledPair {
  double a2, a1, a0, g_re, g_im;
};

UPBEAD_CLONES void add(const SampledPair& p, Eigen::Index n, const double* q_re, const double* q_im, double* re,
                       double* im) {
  for (Eigen::Index j = 0; j < n; ++j) {
    const double x = q_re[j], y = q_im[j];
    const double c = p.a2 * x + p.a1, d = p.a2 * y, u = c * x - d * y + p.a0, v = c * y + d * x;
    const double dx = x - p.g_re, down = y - p.g_im, up = y + p.g_im;
    const double s = dx * dx - down * up, t = dx * (down + up), size = 1. / (s * s + t * t);
    re[j] += (u * s + v * t) * size;
    im[j] += (v * s - u * t) * size;
  }
}

/// The term of a pair of poles: (a1 i omega + a0) / (|p|^2 - omega^2 - 2 i omega Re p).
struct Pair {
  double a1, a0, square, twice_real;
};

UPBEAD_CLONES void add(const Pair& p, Eigen::Index n, const double* omega, double* re, double* im) {
  for (Eigen::Index j = 0; j < n; ++j) {
    const double w = omega[j], u = p.a0, v = p.a1 * w, s = p.square - w * w, t = -p.twice_real * w;
    const double size = 1. / (s * s + t * t);
    re[j] += (u * s + v * t) * size;
    im[j] += (v * s - u * t) * size;
  }
}

/// Sampled transfer function of load k: what the recurrence of every mode gives for loads that are straight between
/// samples; `q` is Z - 1. With g = E - 1, a pair of conjugate poles gives real coefficients over (q - g) (q - conj
/// g), without cancellation even where the step is short compared with 1/|pole|.
Eigen::VectorXcd sampled_transfer(const ModalModel& model, int i, int k, double h, const Eigen::ArrayXcd& q) {
  const Eigen::ArrayXd q_re = q.real(), q_im = q.imag();
  Sums H(q.size());
  for (int m = 0; m < model.n_modes(); ++m) {
    const Complex residue = model.reading(i, m) * model.load(m, k);
    if (residue == 0.) continue;
    const detail::PhiFunctions phi = detail::phi_functions(model.pole[m] * h);
    const Complex g = model.pole[m] * h * phi.phi1, u = residue * h * phi.phi1, v = residue * h * phi.phi2;
    add({v.real(), (u - v * std::conj(g)).real(), -(u * std::conj(g)).real(), g.real(), g.imag()}, q.size(),
        q_re.data(), q_im.data(), H.re.data(), H.im.data());
  }
  Eigen::VectorXcd sum = H.complex();
  sum.array() += model.feedthrough(i, k);
  if (model.impulse(i, k) != 0.) sum.array() += model.impulse(i, k) * h * (1. + 0.5 * q) / q;
  return sum;
}

/// ModalModel::transfer() at i omega; no omega may be zero.
Eigen::VectorXcd transfer(const ModalModel& model, int i, int k, const Eigen::ArrayXd& omega) {
  Sums H(omega.size());
  for (int m = 0; m < model.n_modes(); ++m) {
    const Complex residue = model.reading(i, m) * model.load(m, k), pole = model.pole[m];
    if (residue == 0.) continue;
    add({residue.real(), -(residue * std::conj(pole)).real(), std::norm(pole), 2. * pole.real()}, omega.size(),
        omega.data(), H.re.data(), H.im.data());
  }
  H.im -= model.impulse(i, k) / omega;
  H.re += model.feedthrough(i, k);
  return H.complex();
}

}  // namespace

double ResponseDifference::bound() const {
  return safety_of_model * of_model.cwiseAbs().maxCoeff() + safety * of_middle.cwiseAbs().maxCoeff();
}

/// Up to this number of waves the recurrences themselves are used, beyond it the FFT: making the transfer functions
/// takes as long as so many waves.
constexpr int few_waves = 30;

struct ResponseError::ByFft {
  ByFft(const ModalModel& model, int reading, const NestedModels& nested, double step, int n)
      : fft(static_cast<Eigen::Index>(padding * n) + 1),
        weight(n),
        of_model(fft.size() / 2 + 1, model.n_loads()),
        of_middle(of_model.rows(), of_model.cols()),
        safety(nested.safety) {
    for (Eigen::Index j = 0; j < n; ++j)
      weight[j] = std::exp(-wrapped * static_cast<double>(j) / static_cast<double>(fft.size()));
    const Eigen::ArrayXcd q = contour(fft.size());
    for (int k = 0; k < model.n_loads(); ++k) {
      const Eigen::VectorXcd reference = sampled_transfer(nested.reference, 0, k, step, q);
      of_model.col(k) = reference - sampled_transfer(model, reading, k, step, q);
      of_middle.col(k) = reference - sampled_transfer(nested.middle, 0, k, step, q);
    }
  }

  ResponseDifference of(const Eigen::Ref<const WaveSamples>& loads) const {
    Eigen::VectorXcd model = Eigen::VectorXcd::Zero(of_model.rows()), middle = model;
    for (Eigen::Index k = 0; k < loads.rows(); ++k) {
      if (loads.row(k).isZero(0.)) continue;
      const Eigen::VectorXcd F = fft.forward(loads.row(k).transpose().cwiseProduct(weight));
      model += of_model.col(k).cwiseProduct(F);
      middle += of_middle.col(k).cwiseProduct(F);
    }
    const auto in_time = [&](Eigen::VectorXcd& amplitude) -> Eigen::VectorXd {
      return fft.backward(std::move(amplitude)).head(loads.cols()).cwiseQuotient(weight);
    };
    return {in_time(model), in_time(middle), safety};
  }

  detail::RealFft fft;
  Eigen::VectorXd weight;                ///< exp(-sigma t) of the samples
  Eigen::MatrixXcd of_model, of_middle;  ///< frequencies of the FFT x K
  double safety;
};

ResponseError::ResponseError(const ModalModel& model, int reading, const NestedModels& nested, double step, int n,
                             int n_waves)
    : n_loads_(model.n_loads()), n_(n), safety_(nested.safety) {
  if (n_waves > few_waves)
    by_fft_ = std::make_shared<const ByFft>(model, reading, nested, step, n);
  else
    models_ = {{model, reading, step}, {nested.middle, 0, step}, {nested.reference, 0, step}};
}

ResponseDifference ResponseError::of(const Eigen::Ref<const WaveSamples>& loads) const {
  if (loads.rows() != n_loads_ || loads.cols() != n_)
    throw std::invalid_argument("a wave's loads do not fit the reduced model or its check");
  if (by_fft_) return by_fft_->of(loads);
  WaveSamples from_zero = WaveSamples::Zero(n_loads_, n_ + 1);  // the first sample is reached along a line, too
  from_zero.rightCols(n_) = loads;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> y(3, n_ + 1);
  for (int i = 0; i < 3; ++i) models_[static_cast<std::size_t>(i)].respond(from_zero, y.row(i));
  return {(y.row(2) - y.row(0)).tail(n_).transpose(), (y.row(2) - y.row(1)).tail(n_).transpose(), safety_};
}

/// The part of sampled_transfer() from beyond `omega`. Lines between samples contain each frequency of the FFT and
/// its aliases, 2 pi j / h away, with the weight sinc^2, the spectrum of a sample's hat function; at the times of the
/// samples all aliases look alike. The contributions of aliases below `omega` are subtracted; the rest comes from the
/// corners of the lines.
BandCheck::BandCheck(const ModalModel& model, int reading, double step, int n, double omega)
    : n_(n), fft_(std::make_shared<const detail::RealFft>(2 * n)), transfer_(fft_->size() / 2 + 1, model.n_loads()) {
  const Eigen::Index J = transfer_.rows();
  const double round = 2. * pi / step;
  const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(J, 0., static_cast<double>(J - 1)) * round / fft_->size();
  Eigen::ArrayXcd q(J);
  for (Eigen::Index j = 0; j < J; ++j) q[j] = std::polar(1., at[j] * step) - 1.;
  const int aliases = static_cast<int>(std::ceil(omega / round));
  for (int k = 0; k < model.n_loads(); ++k) {
    transfer_.col(k) = sampled_transfer(model, reading, k, step, q);
    for (int a = -aliases; a <= aliases; ++a) {
      const Eigen::ArrayXd alias = at + a * round, half = 0.5 * step * alias;
      const auto below = alias.abs() <= omega && alias != 0.;
      if (!below.any()) continue;
      const Eigen::ArrayXd hat = below.select((half.sin() / half).square(), 0.);
      const Eigen::VectorXcd H = transfer(model, reading, k, below.select(alias, omega));
      transfer_.col(k) -= hat.matrix().cwiseProduct(H);
    }
    transfer_(0, k) = 0.;  // lines between equal samples have no corners
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
