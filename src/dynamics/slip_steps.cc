#include "dynamics/slip_steps.h"

#include <algorithm>
#include <cmath>

#include "dynamics/phi_functions.h"

namespace upbead {

namespace {

using detail::Lanes;
using detail::lanes;
using detail::SplitArray;
using Complex = std::complex<double>;

/// All that a step reads, and where it writes.
struct StepArrays {
  const SplitArray &E, &watched, &normal;
  const std::vector<SlipSteps::Input>& inputs;
  const Eigen::VectorXd &begin, &end;
  const SplitArray& from;
  SplitArray& to;
};

/// Moves modes [first, last), whole numbers of lanes, and adds what is read of them by lane; real ones have no
/// imaginary parts.
template <bool is_real>
UPBEAD_IN_CLONES void add_modes(Eigen::Index first, Eigen::Index last, const StepArrays& s, Lanes& watched,
                                Lanes& normal) {
  for (Eigen::Index m = first; m < last; m += lanes) {
    Lanes a, b, re, im, next_im = {};
    detail::load(s.from.re.data() + m, re);
    detail::load(s.E.re.data() + m, a);
    Lanes next_re = a * re;
    if constexpr (!is_real) {
      detail::load(s.from.im.data() + m, im);
      detail::load(s.E.im.data() + m, b);
      next_re -= b * im;
      next_im = a * im + b * re;
    }
    const auto add = [&](double value, const SplitArray& input) __attribute__((always_inline)) {
      detail::load(input.re.data() + m, a);
      next_re += value * a;
      if constexpr (is_real) return;
      detail::load(input.im.data() + m, b);
      next_im += value * b;
    };
    for (const SlipSteps::Input& input : s.inputs) {
      add(s.begin[input.load], input.begin);
      add(s.end[input.load], input.end);
    }
    detail::store(next_re, s.to.re.data() + m);
    if constexpr (!is_real) detail::store(next_im, s.to.im.data() + m);
    const auto read = [&](const SplitArray& row, Lanes& sum) __attribute__((always_inline)) {
      detail::load(row.re.data() + m, a);
      sum += a * next_re;
      if constexpr (is_real) return;
      detail::load(row.im.data() + m, b);
      sum -= b * next_im;
    };
    read(s.watched, watched);
    read(s.normal, normal);
  }
}

UPBEAD_CLONES void add_step(Eigen::Index n_pairs, const StepArrays& s, SlipStep& y) {
  Lanes watched = {}, normal = {};
  add_modes<false>(0, n_pairs, s, watched, normal);
  add_modes<true>(n_pairs, s.E.re.size(), s, watched, normal);
  for (int lane = 0; lane < lanes; ++lane) {
    y.watched += watched[lane];
    y.normal += normal[lane];
  }
}

/// Parts of the products a b, not yet computed: what they make up is computed at once.
auto real(const SplitArray& a, const SplitArray& b) {
  return a.re * b.re - a.im * b.im;
}

auto imag(const SplitArray& a, const SplitArray& b) {
  return a.re * b.im + a.im * b.re;
}

/// The real part of sum row z.
double read(const SplitArray& row, const SplitArray& z) {
  return real(row, z).sum();
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

SlipSteps::SlipSteps(const SlipPhase& phase, ContactState contact, const Eigen::MatrixXd& rows, double step)
    : step_(step) {
  const ModalModel& modes = phase.modes;
  const int row = watched_row(contact);
  const Eigen::Index M = modes.n_modes();
  Eigen::VectorXcd E(M), phi1(M), phi2(M), phi3(M);
  for (Eigen::Index m = 0; m < M; ++m) {
    const Complex x = modes.pole[m] * step;
    const detail::PhiFunctions phi = detail::phi_functions(x);
    E[m] = phi.exp;
    phi1[m] = step * phi.phi1;
    phi2[m] = step * phi.phi2;
    phi3[m] = step * detail::phi3(x, phi.phi2);
  }
  E_ = detail::padded(E);
  n_pairs_ = ((modes.pole.imag().array() > 0.).count() + lanes - 1) / lanes * lanes;
  pole_ = detail::padded(modes.pole);
  watched_ = detail::padded(modes.reading.row(row).transpose());
  normal_ = detail::padded(modes.reading.row(row_normal).transpose());
  const auto integral = [&](const Eigen::VectorXcd& reading) -> Integral {
    const Eigen::RowVectorXcd whole = step * phi2.cwiseProduct(reading).transpose(),
                              rise = step * phi3.cwiseProduct(reading).transpose();
    return {detail::padded(phi1.cwiseProduct(reading)), ((whole - rise) * modes.load).real(),
            (rise * modes.load).real()};
  };
  distance_ = integral(modes.reading.row(row_velocity).transpose());
  for (int k = 0; k < modes.n_loads(); ++k)
    if (const Eigen::VectorXcd load = modes.load.col(k); !load.isZero(0.))
      inputs_.push_back({k, detail::padded(load), detail::padded((phi1 - phi2).cwiseProduct(load)),
                         detail::padded(phi2.cwiseProduct(load))});
  watched_load_ = modes.feedthrough.row(row);
  normal_load_ = modes.feedthrough.row(row_normal);
  velocity_weights_ = weights(modes.reading.row(row_velocity), modes.pole, step);
  normal_weights_ = weights(modes.reading.row(row_normal), modes.pole, step);
  const Eigen::MatrixXd of_modes = rows * phase.to_state;
  for (int k = 0; k < rows.rows(); ++k) {
    if (of_modes.row(k).isZero(0.)) continue;
    const Eigen::VectorXcd worker = (of_modes.row(k).head(M) - Complex(0., 1.) * of_modes.row(k).tail(M)).transpose();
    workers_.push_back({k, detail::padded(worker), integral(worker), weights(worker, modes.pole, step)});
  }
}

SlipSteps::Weights SlipSteps::weights(const Eigen::VectorXcd& reading, const Eigen::VectorXcd& pole, double step) {
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

SlipStep SlipSteps::advance(const SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end,
                            SplitArray& to) const {
  SlipStep y{watched_load_.dot(end), normal_load_.dot(end)};
  add_step(n_pairs_, {E_, watched_, normal_, inputs_, begin, end, from, to}, y);
  return y;
}

SplitArray SlipSteps::rate(const Eigen::VectorXd& loads) const {
  SplitArray all{Eigen::ArrayXd::Zero(E_.re.size()), Eigen::ArrayXd::Zero(E_.re.size())};
  for (const Input& input : inputs_) {
    all.re += loads[input.load] * input.rate.re;
    all.im += loads[input.load] * input.rate.im;
  }
  return all;
}

SlipWithin SlipSteps::within(const SplitArray& from, const SplitArray& to, const Eigen::VectorXd& begin,
                             const Eigen::VectorXd& end) const {
  const SplitArray start = rate(begin), rise = rate((end - begin) / step_);  // z' = p z + start + rise t
  const SplitArray first{real(pole_, from) + start.re, imag(pole_, from) + start.im};
  const Eigen::ArrayXd size =
      ((real(pole_, first) + rise.re).square() + (imag(pole_, first) + rise.im).square()).sqrt();  // |z''(0)|
  const auto bend = [&size](const Weights& w) { return SlipBend{(w.slow * size).sum(), (w.fast * size).sum()}; };
  const auto integral = [&](const Integral& i) { return read(i.from, from) + i.begin.dot(begin) + i.end.dot(end); };
  SlipWithin y{bend(velocity_weights_), bend(normal_weights_), integral(distance_)};
  for (const Worker& worker : workers_) {
    const double f = begin[worker.load], g = end[worker.load];
    y.work += 0.5 * (f + g) * integral(worker.integral);
    if (f == g) continue;
    y.work += step_ / 12. * (g - f) * (read(worker.row, to) - read(worker.row, from));
    const SlipBend of_work = bend(worker.weights);
    y.work_error += 0.25 * step_ * std::abs(g - f) * (of_work.slow + of_work.fast);
  }
  return y;
}

double SlipSteps::work_of_piece(const SplitArray& from, const SplitArray& to, const Eigen::VectorXd& begin,
                                const Eigen::VectorXd& end, double length) const {
  double work = 0.;
  for (const Worker& worker : workers_)
    work +=
        integral_of_product(begin[worker.load], end[worker.load], read(worker.row, from), read(worker.row, to), length);
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
