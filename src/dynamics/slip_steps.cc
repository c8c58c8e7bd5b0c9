#include "dynamics/slip_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "dynamics/phi_functions.h"

namespace upbead {

namespace {

using detail::Lanes;
using detail::lanes;
using detail::SplitArray;
using Complex = std::complex<double>;

/// The most loads that may move the modes.
constexpr std::size_t most_inputs = 16;

struct InputPointers {
  const double *begin_re, *begin_im, *end_re, *end_im;
  double at_begin, at_end;
};

struct StepPointers {
  const double *E_re, *E_im, *watched_re, *watched_im, *normal_re, *normal_im, *distance_re, *distance_im;
  const double *re, *im;
  double *to_re, *to_im;
  std::size_t n_inputs;
  std::array<InputPointers, most_inputs> inputs;
};

double sum(const Lanes& values) {
  double total = 0.;
  for (int lane = 0; lane < lanes; ++lane) total += values[lane];
  return total;
}

/// Sums over the modes, by lane.
struct StepSums {
  Lanes watched = {}, normal = {}, distance = {};
};

/// Adds the first `n_pairs` modes, which may be complex; a whole number of lanes.
UPBEAD_CLONES void add_pairs(Eigen::Index n_pairs, const StepPointers& p, StepSums& sums) {
  for (Eigen::Index m = 0; m < n_pairs; m += lanes) {
    Lanes a, b, re, im;
    detail::load(p.re + m, re);
    detail::load(p.im + m, im);
    detail::load(p.distance_re + m, a);
    detail::load(p.distance_im + m, b);
    sums.distance += a * re - b * im;
    detail::load(p.E_re + m, a);
    detail::load(p.E_im + m, b);
    Lanes next_re = a * re - b * im, next_im = a * im + b * re;
    for (std::size_t k = 0; k < p.n_inputs; ++k) {
      const InputPointers& input = p.inputs[k];
      detail::load(input.begin_re + m, a);
      detail::load(input.begin_im + m, b);
      next_re += input.at_begin * a;
      next_im += input.at_begin * b;
      detail::load(input.end_re + m, a);
      detail::load(input.end_im + m, b);
      next_re += input.at_end * a;
      next_im += input.at_end * b;
    }
    detail::store(next_re, p.to_re + m);
    detail::store(next_im, p.to_im + m);
    detail::load(p.watched_re + m, a);
    detail::load(p.watched_im + m, b);
    sums.watched += a * next_re - b * next_im;
    detail::load(p.normal_re + m, a);
    detail::load(p.normal_im + m, b);
    sums.normal += a * next_re - b * next_im;
  }
}

/// Adds the real modes from `n_pairs` on; whole numbers of lanes.
UPBEAD_CLONES void add_real(Eigen::Index n_pairs, Eigen::Index n_modes, const StepPointers& p, StepSums& sums) {
  for (Eigen::Index m = n_pairs; m < n_modes; m += lanes) {
    Lanes a, re;
    detail::load(p.re + m, re);
    detail::load(p.distance_re + m, a);
    sums.distance += a * re;
    detail::load(p.E_re + m, a);
    Lanes next = a * re;
    for (std::size_t k = 0; k < p.n_inputs; ++k) {
      detail::load(p.inputs[k].begin_re + m, a);
      next += p.inputs[k].at_begin * a;
      detail::load(p.inputs[k].end_re + m, a);
      next += p.inputs[k].at_end * a;
    }
    detail::store(next, p.to_re + m);
    detail::load(p.watched_re + m, a);
    sums.watched += a * next;
    detail::load(p.normal_re + m, a);
    sums.normal += a * next;
  }
}

void add_step(Eigen::Index n_pairs, Eigen::Index n_modes, const StepPointers& p, SlipStep& y) {
  StepSums sums;
  add_pairs(n_pairs, p, sums);
  add_real(n_pairs, n_modes, p, sums);
  y.watched += sum(sums.watched);
  y.normal += sum(sums.normal);
  y.distance += sum(sums.distance);
}

}  // namespace

SlipSteps::SlipSteps(const SlipPhase& phase, ContactState contact, double step) {
  const ModalModel& modes = phase.modes;
  if (static_cast<std::size_t>(modes.n_loads()) > most_inputs)
    throw std::invalid_argument("a slip model has 16 loads at most");
  const int row = watched_row(contact);
  const Eigen::Index M = modes.n_modes();
  Eigen::VectorXcd E(M), rise(M), whole(M), distance(M), distance_whole(M), distance_rise(M);
  for (Eigen::Index m = 0; m < M; ++m) {
    const Complex x = modes.pole[m] * step;
    const detail::PhiFunctions phi = detail::phi_functions(x);
    E[m] = phi.exp;
    whole[m] = step * phi.phi1;
    rise[m] = step * phi.phi2;
    distance[m] = modes.reading(row, m) * step * phi.phi1;
    distance_whole[m] = modes.reading(row, m) * step * step * phi.phi2;
    distance_rise[m] = modes.reading(row, m) * step * step * detail::phi3(x, phi.phi2);
  }
  E_ = detail::padded(E);
  const Eigen::Index pairs = (modes.pole.imag().array() > 0.).count();
  n_pairs_ = (pairs + lanes - 1) / lanes * lanes;
  watched_ = detail::padded(modes.reading.row(row).transpose());
  normal_ = detail::padded(modes.reading.row(row_normal).transpose());
  distance_ = detail::padded(distance);
  for (int k = 0; k < modes.n_loads(); ++k)
    if (!modes.load.col(k).isZero(0.))
      inputs_.push_back({k, detail::padded((whole - rise).cwiseProduct(modes.load.col(k))),
                         detail::padded(rise.cwiseProduct(modes.load.col(k)))});
  watched_load_ = modes.feedthrough.row(row);
  normal_load_ = modes.feedthrough.row(row_normal);
  distance_end_ = (distance_rise.transpose() * modes.load).real() + 0.5 * step * watched_load_;
  distance_begin_ = ((distance_whole - distance_rise).transpose() * modes.load).real() + 0.5 * step * watched_load_;
}

SlipStep SlipSteps::advance(const SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end,
                            SplitArray& to) const {
  SlipStep y{watched_load_.dot(end), normal_load_.dot(end), distance_begin_.dot(begin) + distance_end_.dot(end)};
  StepPointers p{E_.re.data(),        E_.im.data(),
                 watched_.re.data(),  watched_.im.data(),
                 normal_.re.data(),   normal_.im.data(),
                 distance_.re.data(), distance_.im.data(),
                 from.re.data(),      from.im.data(),
                 to.re.data(),        to.im.data(),
                 inputs_.size(),      {}};
  for (std::size_t k = 0; k < inputs_.size(); ++k) {
    const Input& input = inputs_[k];
    p.inputs[k] = {input.begin.re.data(), input.begin.im.data(), input.end.re.data(),
                   input.end.im.data(),   begin[input.load],     end[input.load]};
  }
  add_step(n_pairs_, E_.re.size(), p, y);
  return y;
}

namespace {

/// The real part of sum row z.
double sum(const SplitArray& row, const SplitArray& z) {
  return (row.re * z.re - row.im * z.im).sum();
}

/// Integral over `length` of the product of two lines, from a to b and from c to d.
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
