#include "upbead/dynamics/modal_response.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "phi_functions.h"

namespace upbead {

namespace {

/// Advances all modes step by step.
class RecurringModes {
 public:
  explicit RecurringModes(const ModalModel& model)
      : model_(model),
        z_(Eigen::VectorXcd::Zero(model.n_modes())),
        E_(model.n_modes()),
        whole_(model.n_modes()),
        rise_(model.n_modes()) {}

  /// Advances to `time` (s) under loads that go from `begin` to `end` (K each).
  void advance(double time, const Eigen::VectorXd& begin, const Eigen::VectorXd& end) {
    prepare(time);
    z_.array() = E_.array() * z_.array() + whole_.array() * (model_.load * begin).array() +
                 rise_.array() * (model_.load * (end - begin)).array();
  }
  const Eigen::VectorXcd& z() const { return z_; }

 private:
  /// Equal steps differ in their last digits where they are differences of times, yet new exponentials cost more than
  /// all else. So a step counts as equal to the latest one where its end is within 1e-9 of a step from the end that
  /// equal steps would have. Ends are compared, not sizes, so that the error does not grow with the number of steps;
  /// where equal steps have drifted too far, the step is stretched.
  void prepare(double time) {
    if (n_equal_ > 0 && std::abs(segment_start_ + (n_equal_ + 1) * step_ - time) <= 1e-9 * step_) {
      ++n_equal_;
      return;
    }
    segment_start_ += n_equal_ * step_;
    const double before = std::exchange(step_, time - segment_start_);
    n_equal_ = 1;
    if (std::abs(step_ - before) <= 1e-8 * before) return stretch(before);
    for (Eigen::Index m = 0; m < z_.size(); ++m) {
      const detail::PhiFunctions phi = detail::phi_functions(model_.pole[m] * step_);
      E_[m] = phi.exp;
      whole_[m] = step_ * phi.phi1;
      rise_[m] = step_ * phi.phi2;
    }
  }

  /// Changes the coefficients from a step of `before` to one of step_, which differs so little that the square of the
  /// change is round-off: with h phi1 = (e^(p h) - 1) / p and h phi2 = (h phi1 - h) / (p h), d(h phi1)/dh = e^(p h),
  /// d(h phi2)/dh = phi1 - phi2.
  void stretch(double before) {
    const double longer = step_ - before;
    rise_.array() += (whole_.array() - rise_.array()) * (longer / before);
    whole_.array() += E_.array() * longer;
    E_.array() += model_.pole.array() * E_.array() * longer;
  }

  const ModalModel& model_;
  Eigen::VectorXcd z_;
  Eigen::VectorXcd E_, whole_, rise_;  ///< of a step of step_
  double segment_start_ = 0., step_ = 0.;
  int n_equal_ = 0;  ///< steps of step_ since segment_start_
};

void check_shapes(const ModalModel& model, const SampledLoads& loads) {
  const auto n = static_cast<Eigen::Index>(loads.time.size()) - 1;
  const auto fits = [&](const Eigen::MatrixXd& f) { return f.rows() == model.n_loads() && f.cols() == n; };
  if (!fits(loads.begin) || !fits(loads.end))
    throw std::invalid_argument("sampled loads do not fit the reduced model or their times");
}

/// int_0^t f_k at all times, K x (N + 1).
Eigen::MatrixXd integrals(const SampledLoads& loads) {
  Eigen::MatrixXd integral = Eigen::MatrixXd::Zero(loads.end.rows(), loads.end.cols() + 1);
  for (Eigen::Index n = 0; n < loads.end.cols(); ++n)
    integral.col(n + 1) =
        integral.col(n) + 0.5 * (loads.time[n + 1] - loads.time[n]) * (loads.begin.col(n) + loads.end.col(n));
  return integral;
}

}  // namespace

SampledLoads sample(const std::vector<TimeFunction>& loads, const std::vector<double>& time) {
  const auto n_loads = static_cast<Eigen::Index>(loads.size()), n = static_cast<Eigen::Index>(time.size()) - 1;
  SampledLoads sampled{time, Eigen::MatrixXd(n_loads, n), Eigen::MatrixXd(n_loads, n)};
  for (Eigen::Index k = 0; k < n_loads; ++k)
    for (Eigen::Index i = 0; i < n; ++i) {
      // Times meet kinks up to round-off only.
      const double begin = time[i], end = time[i + 1], inside = 1e-3 * (end - begin);
      sampled.begin(k, i) = loads[k](begin, begin + inside);
      sampled.end(k, i) = loads[k](end, end - inside);
    }
  return sampled;
}

Series respond(const ModalModel& model, const SampledLoads& loads) {
  check_shapes(model, loads);
  const Eigen::Index n = loads.end.cols(), n_modes = model.n_modes();
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(model.n_loads(), n + 1);
  load.rightCols(n) = loads.end;
  Series series{loads.time, model.feedthrough * load + model.impulse * integrals(loads), load};

  // Re (reading z) as a product of real matrices, for blocks of times that stay in the cache.
  constexpr Eigen::Index largest_block = 256;
  Eigen::MatrixXd reading(model.n_readings(), 2 * n_modes), z(2 * n_modes, largest_block);
  reading << model.reading.real(), -model.reading.imag();
  RecurringModes modes(model);
  for (Eigen::Index first = 0; first < n; first += largest_block) {
    const Eigen::Index block = std::min(largest_block, n - first);
    for (Eigen::Index i = 0; i < block; ++i) {
      modes.advance(loads.time[first + i + 1], loads.begin.col(first + i), loads.end.col(first + i));
      z.col(i) << modes.z().real(), modes.z().imag();
    }
    series.reading.middleCols(first + 1, block).noalias() += reading * z.leftCols(block);
  }
  return series;
}

}  // namespace upbead
