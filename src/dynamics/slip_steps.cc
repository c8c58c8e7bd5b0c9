#include "dynamics/slip_steps.h"

#include <array>
#include <stdexcept>

#include "lanes.h"
#include "phi_functions.h"

namespace upbead {

namespace {

using detail::Lanes;
using detail::lanes;
using detail::SplitArray;
using Complex = std::complex<double>;

/// Loads that move the modes.
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

/// Of the modes of one lane each.
struct StepSums {
  Lanes watched = {}, normal = {}, distance = {};
};

/// The first `n_pairs` modes, which may be complex; a whole number of lanes.
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

/// The real modes from `n_pairs` on; whole numbers of lanes.
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

}  // namespace upbead
