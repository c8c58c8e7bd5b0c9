#include "dynamics/readings_at.h"

#include <algorithm>
#include <complex>
#include <stdexcept>

#include "algebra/dense.h"
#include "dynamics/phi_functions.h"

namespace upbead {

namespace {

using detail::lanes;
using detail::Lanes;
using detail::SplitArray;

/// w <- E w + f_n for n samples, mode by mode.
UPBEAD_CLONES void advance_modes(Eigen::Index n_modes, const double* E_re, const double* E_im, double* w_re,
                                 double* w_im, const double* f, Eigen::Index n) {
  for (Eigen::Index m = 0; m < n_modes; m += lanes) {
    Lanes a, b, re, im;
    detail::load(E_re + m, a);
    detail::load(E_im + m, b);
    detail::load(w_re + m, re);
    detail::load(w_im + m, im);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Lanes next = f[i] + a * re - b * im;
      im = a * im + b * re;
      re = next;
    }
    detail::store(re, w_re + m);
    detail::store(im, w_im + m);
  }
}

void advance(const SplitArray& E, SplitArray& w, const double* f, Eigen::Index n) {
  constexpr Eigen::Index between_drops = 64;  // samples after which numbers that have decayed are dropped
  for (Eigen::Index i = 0; i < n; i += between_drops) {
    detail::flush_denormals(w);
    advance_modes(E.re.size(), E.re.data(), E.im.data(), w.re.data(), w.im.data(), f + i,
                  std::min(between_drops, n - i));
  }
}

/// int f dt at those samples, f straight in between.
Eigen::RowVectorXd integrals_at(const Eigen::RowVectorXd& f, double step, const std::vector<std::size_t>& times) {
  Eigen::RowVectorXd found(times.size());
  double sum = 0.;
  std::size_t n = 0;
  for (std::size_t c = 0; c < times.size(); ++c) {
    for (; n < times[c]; ++n)
      sum += 0.5 * step * (f[static_cast<Eigen::Index>(n)] + f[static_cast<Eigen::Index>(n + 1)]);
    found[static_cast<Eigen::Index>(c)] = sum;
  }
  return found;
}

void check_times(const std::vector<std::size_t>& times, Eigen::Index n) {
  if (!std::is_sorted(times.begin(), times.end()) || (!times.empty() && static_cast<Eigen::Index>(times.back()) >= n))
    throw std::invalid_argument("the times of readings are not ascending, or beyond the loads");
}

}  // namespace

/// Of w see batch_response.cc.
ReadingsAt::ReadingsAt(const ModalModel& model, double step)
    : step_(step), n_modes_(model.n_modes()), direct_(model.feedthrough), impulse_(model.impulse) {
  Eigen::VectorXcd E(n_modes_), start(n_modes_), input(n_modes_), at_once(n_modes_);
  for (Eigen::Index m = 0; m < n_modes_; ++m) {
    const detail::PhiFunctions phi = detail::phi_functions(model.pole[m] * step);
    const std::complex<double> square = phi.phi1 * phi.phi1;
    E[m] = phi.exp;
    start[m] = -phi.phi2 / square;
    input[m] = step * square;
    at_once[m] = step * phi.phi2;
  }
  E_ = detail::padded(E);
  start_ = detail::padded(start);
  for (int k = 0; k < model.n_loads(); ++k) {
    const Eigen::MatrixXcd of_w = model.reading * input.cwiseProduct(model.load.col(k)).asDiagonal();
    Eigen::MatrixXd& parts = reading_.emplace_back(model.n_readings(), 2 * n_modes_);
    parts << of_w.real(), -of_w.imag();
  }
  direct_ += (model.reading * (at_once.asDiagonal() * model.load)).real();
}

Eigen::MatrixXd ReadingsAt::of(const Eigen::Ref<const WaveSamples>& loads,
                               const std::vector<std::size_t>& times) const {
  if (loads.rows() != direct_.cols()) throw std::invalid_argument("a wave's loads do not fit the reduced model");
  check_times(times, loads.cols());
  const auto n_times = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(direct_.rows(), n_times), state(2 * n_modes_, n_times);
  for (Eigen::Index k = 0; k < loads.rows(); ++k) {
    const Eigen::RowVectorXd f = loads.row(k);
    if (f.isZero(0.)) continue;
    SplitArray w{start_.re * f[0], start_.im * f[0]};
    Eigen::Index at = 0;
    for (Eigen::Index c = 0; c < n_times; ++c) {
      const auto next = static_cast<Eigen::Index>(times[static_cast<std::size_t>(c)]);
      advance(E_, w, f.data() + at, next - at);
      at = next;
      state.col(c) << w.re.head(n_modes_).matrix(), w.im.head(n_modes_).matrix();
      y.col(c) += direct_.col(k) * f[at];
    }
    y += product(reading_[static_cast<std::size_t>(k)], state);
    if (!impulse_.col(k).isZero(0.)) y += impulse_.col(k) * integrals_at(f, step_, times);
  }
  return y;
}

Eigen::MatrixXd respond_at(const ModalModel& model, const SampledLoads& loads, const std::vector<std::size_t>& times) {
  check_times(times, static_cast<Eigen::Index>(loads.time.size()));
  // few readings at all times, as many as the model has modes, and then all readings at few of them
  const Eigen::Index M = model.n_modes(), K = model.n_loads();
  ModalModel states = model;
  states.reading = Eigen::MatrixXcd::Zero(2 * M, M);
  states.reading.topRows(M).diagonal().setOnes();
  states.reading.bottomRows(M).diagonal().setConstant({0., -1.});  // Re(-i z) = Im z
  states.feedthrough = states.impulse = Eigen::MatrixXd::Zero(2 * M, K);
  states.reading_label.assign(static_cast<std::size_t>(2 * M), {});
  const Series series = respond(states, loads);
  Eigen::MatrixXd reading(model.n_readings(), 2 * M), state(2 * M, times.size()), f(K, times.size()), area = f;
  reading << model.reading.real(), -model.reading.imag();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(K);
  std::size_t n = 0;
  for (std::size_t c = 0; c < times.size(); ++c) {
    for (; n < times[c]; ++n) {
      const auto i = static_cast<Eigen::Index>(n);
      sum += 0.5 * (loads.time[n + 1] - loads.time[n]) * (loads.begin.col(i) + loads.end.col(i));
    }
    const auto column = static_cast<Eigen::Index>(c), at = static_cast<Eigen::Index>(times[c]);
    state.col(column) = series.reading.col(at);
    f.col(column) = series.load.col(at);
    area.col(column) = sum;
  }
  return reading * state + model.feedthrough * f + model.impulse * area;
}

}  // namespace upbead
