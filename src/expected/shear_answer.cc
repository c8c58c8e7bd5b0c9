#include "expected/shear_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace upbead {

namespace {

constexpr int windows = 400;  // widths that are looked at

/// The model with one load and one reading.
ModalModel one_path(const ShearModel& model) {
  const ModalModel& all = model.modes;
  ModalModel one;
  one.pole = all.pole;
  one.load = all.load.col(model.load);
  one.reading = all.reading.row(model.shear);
  one.feedthrough = all.feedthrough.block(model.shear, model.load, 1, 1);
  one.impulse = all.impulse.block(model.shear, model.load, 1, 1);
  one.load_name = {all.load_name[static_cast<std::size_t>(model.load)]};
  one.reading_label = {all.reading_label[static_cast<std::size_t>(model.shear)]};
  return one;
}

}  // namespace

ShearAnswer::ShearAnswer(const ShearModel& model, double step, double longest)
    : step_(step),
      mass_(model.caisson_mass),
      load_per_force_(1. / model.force_per_load),
      batch_(one_path(model), 0, step) {
  if (model.force_per_load == 0.) throw std::invalid_argument("the load puts no horizontal force on the caisson");
  make_bounds(static_cast<int>(std::ceil(longest / step)) + 2);
}

void ShearAnswer::make_bounds(int n) {
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> unit(size, 0.), hat(size), ramp(size);
  unit[1] = 1.;
  respond(unit.data(), n, hat.data());
  std::fill(unit.begin() + 1, unit.end(), 1.);
  respond(unit.data(), n, ramp.data());
  hat_.assign(size, 0.);
  late_.assign(size, 0.);
  for (std::size_t i = 1; i < size; ++i) {
    hat_[i] = hat_[i - 1] + std::abs(hat[i]);
    late_[i] = late_[i - 1] + step_ * std::abs(ramp[i] - 1.);
  }
  stride_ = 1 + n / windows;
  for (std::size_t width = 0; width < size; width += static_cast<std::size_t>(stride_)) {
    double most = 0.;
    for (std::size_t i = 0; i + width < size; ++i) most = std::max(most, late_[i + width] - late_[i]);
    late_windows_.push_back(most);
  }
}

void ShearAnswer::respond(const double* force, int n, double* shear) const {
  const WaveSamples loads = load_per_force_ * Eigen::Map<const Eigen::RowVectorXd>(force, n);
  Eigen::RowVectorXd answer(n);
  batch_.respond(loads, answer);
  Eigen::Map<Eigen::RowVectorXd>(shear, n) = answer;
}

/// F_T(t_n) = sum_k a_(n-k) P_k is at most the largest |P| times the sum of all |a|. Summed by parts it is also
/// P_n + sum_k (P_k - P_(k-1)) (s_(n-k) - 1), of which the sum is at most its steep part, on whatever neighbours |s -
/// 1| is largest, and its rest. The first bound is better for stiff caissons and jumps, the second for slow waves.
double ShearAnswer::bound(const ForceLimits& force, int n) const {
  const auto i = static_cast<std::size_t>(n);
  if (i >= hat_.size()) return std::numeric_limits<double>::infinity();
  const auto width = static_cast<std::size_t>(force.rise / step_ / stride_) + 2;  // one more for a step across the end
  const double steep = width < late_windows_.size() ? late_windows_[width] : late_[i];
  const double late = force.largest + force.first_slope * steep + force.later_slope * late_[i];
  return std::min(hat_[i] * force.largest, late);
}

}  // namespace upbead
