#include "upbead/algebra/layout.h"

#include <algorithm>
#include <cmath>

#include "algebra/dense.h"

namespace upbead {

void Layout::take_first(double* values, std::size_t n) const {
  if (!processes_) return;
  if (processes_->rank() > 0) std::fill(values, values + n, 0.);
  processes_->sum(values, static_cast<int>(n));
}

bool Layout::first_says(bool value) const {
  double number = value ? 1. : 0.;
  take_first(number);
  return number > 0.;
}

double Layout::largest(double value) const {
  if (!processes_) return value;
  std::vector<double> all(static_cast<std::size_t>(processes_->count()), 0.);
  all[static_cast<std::size_t>(processes_->rank())] = value;
  processes_->sum(all.data(), processes_->count());
  return *std::max_element(all.begin(), all.end());
}

Vector Layout::counted(const Vector& values) const {
  Vector parts = values;
  for (const int i : elsewhere_) parts[i] = 0.;
  return parts;
}

Vector Layout::products(const Eigen::Ref<const Eigen::MatrixXd>& V, const Vector& y) const {
  if (!processes_) return transposed_product(V, y);
  Vector h = transposed_product(V, counted(y));
  add_up(h);
  return h;
}

double Layout::square(const Vector& y) const {
  return processes_ ? sum(counted(y).squaredNorm()) : y.squaredNorm();
}

double Layout::norm(const Vector& y) const {
  return std::sqrt(square(y));
}

Vector Layout::normalised(const Vector& y) const {
  const double length = norm(y);
  return length > 0. ? Vector(y / length) : y;
}

Layout Layout::of(const std::vector<int>& unknowns) const {
  if (!processes_) return {};
  std::vector<int> elsewhere;
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (std::binary_search(elsewhere_.begin(), elsewhere_.end(), unknowns[i])) elsewhere.push_back(static_cast<int>(i));
  return {processes_, std::move(elsewhere)};
}

}  // namespace upbead
