#include "dynamics/slip_within_step.h"

#include <algorithm>
#include <cmath>

#include "lanes.h"
#include "phi_functions.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;
using detail::SplitArray;

/// The real part of sum row z.
double sum(const SplitArray& row, const SplitArray& z) {
  return (row.re * z.re - row.im * z.im).sum();
}

/// The product of two lines over `length`.
double integral_of_product(double a, double b, double c, double d, double length) {
  return length * ((a + b) * (c + d) / 4. + (b - a) * (d - c) / 12.);
}

}  // namespace

bool SlipBend::stays_positive(double begin, double end) const {
  const double a = begin - fast, b = end - fast;
  return a >= 0. && b >= 0. && std::sqrt(a) + std::sqrt(b) >= 2. * std::sqrt(slow);
}

SlipWithinStep::SlipWithinStep(const SlipPhase& phase, const Eigen::MatrixXd& rows, double step) : step_(step) {
  const Eigen::VectorXcd& pole = phase.modes.pole;
  const Eigen::Index M = pole.size();
  velocity_ = weights(phase.modes.reading.row(row_velocity), pole, step);
  normal_ = weights(phase.modes.reading.row(row_normal), pole, step);
  Eigen::VectorXcd integral(M), rise(M), bend(M);
  for (Eigen::Index m = 0; m < M; ++m) {
    const Complex x = pole[m] * step;
    const detail::PhiFunctions phi = detail::phi_functions(x);
    integral[m] = step * phi.phi1;
    bend[m] = step * step * phi.phi2;
    rise[m] = step * step * detail::phi3(x, phi.phi2);
  }
  square_ = detail::padded(pole.cwiseProduct(pole));
  integral_ = detail::padded(integral);
  for (int k = 0; k < phase.modes.n_loads(); ++k) {
    const Eigen::VectorXcd load = phase.modes.load.col(k);
    if (load.isZero(0.)) continue;
    inputs_.push_back({k, detail::padded(pole.cwiseProduct(load)), detail::padded(load),
                       detail::padded((bend - rise).cwiseProduct(load)), detail::padded(rise.cwiseProduct(load))});
  }
  const Eigen::MatrixXd of_modes = rows * phase.to_state;
  for (int k = 0; k < rows.rows(); ++k) {
    if (of_modes.row(k).isZero(0.)) continue;
    const Eigen::VectorXcd row = (of_modes.row(k).head(M) - Complex(0., 1.) * of_modes.row(k).tail(M)).transpose();
    workers_.push_back({k, detail::padded(row), weights(row, pole, step)});
  }
}

SlipWithinStep::Weights SlipWithinStep::weights(const Eigen::VectorXcd& reading, const Eigen::VectorXcd& pole,
                                                double step) {
  const auto n = detail::padded(pole).re.size();
  Weights w{Eigen::ArrayXd::Zero(n), Eigen::ArrayXd::Zero(n)};
  for (Eigen::Index m = 0; m < pole.size(); ++m) {
    const double part = std::abs(reading[m]) * std::max(1., std::exp(pole[m].real() * step)), p = std::abs(pole[m]);
    if (p * step < 4.)
      w.slow[m] = part * step * step / 8.;
    else
      w.fast[m] = part * 2. / (p * p);
  }
  return w;
}

SlipBends SlipWithinStep::bends(const SplitArray& from, const Eigen::VectorXd& begin,
                                const Eigen::VectorXd& end) const {
  Eigen::ArrayXd re = square_.re * from.re - square_.im * from.im, im = square_.re * from.im + square_.im * from.re;
  for (const Input& input : inputs_) {
    const double value = begin[input.load], slope = (end[input.load] - value) / step_;
    re += value * input.bend.re + slope * input.bend_slope.re;
    im += value * input.bend.im + slope * input.bend_slope.im;
  }
  re = (re.square() + im.square()).sqrt();
  const auto bend = [&re](const Weights& w) { return SlipBend{(w.slow * re).sum(), (w.fast * re).sum()}; };
  SlipBends all{bend(velocity_), bend(normal_), 0.};
  for (const Worker& worker : workers_) {
    const double change = std::abs(end[worker.load] - begin[worker.load]);
    if (change == 0.) continue;
    const SlipBend of_work = bend(worker.weights);
    all.work += 0.25 * step_ * change * (of_work.slow + of_work.fast);
  }
  return all;
}

double SlipWithinStep::work(const SplitArray& from, const SplitArray& to, const Eigen::VectorXd& begin,
                            const Eigen::VectorXd& end) const {
  if (workers_.empty()) return 0.;
  SplitArray z{integral_.re * from.re - integral_.im * from.im, integral_.re * from.im + integral_.im * from.re};
  for (const Input& input : inputs_) {
    z.re += begin[input.load] * input.begin.re + end[input.load] * input.end.re;
    z.im += begin[input.load] * input.begin.im + end[input.load] * input.end.im;
  }
  double work = 0.;
  for (const Worker& worker : workers_) {
    const double f = begin[worker.load], g = end[worker.load];
    work += 0.5 * (f + g) * sum(worker.row, z) + step_ / 12. * (g - f) * (sum(worker.row, to) - sum(worker.row, from));
  }
  return work;
}

double SlipWithinStep::work_of_piece(const SplitArray& from, const SplitArray& to, const Eigen::VectorXd& begin,
                                     const Eigen::VectorXd& end, double length) const {
  double work = 0.;
  for (const Worker& worker : workers_)
    work +=
        integral_of_product(begin[worker.load], end[worker.load], sum(worker.row, from), sum(worker.row, to), length);
  return work;
}

Eigen::MatrixXd load_rows(const SlipModel& model) {
  const SlipPhase& free = model.phase(ContactState::open);
  const Eigen::Index M = free.modes.n_modes();
  const Eigen::MatrixXd B =
      free.to_state.leftCols(M) * free.modes.load.real() + free.to_state.rightCols(M) * free.modes.load.imag();
  return B.transpose();
}

}  // namespace upbead
