#include "frequency_response.h"

#include <cmath>
#include <stdexcept>

namespace upbead::test {

FrequencyResponse::FrequencyResponse(const System& system, double omega) : system_(system), omega_(omega) {
  const Complex i_omega(0., omega);
  matrix_ =
      (system.M.cast<Complex>() * (i_omega * i_omega) + system.C.cast<Complex>() * i_omega + system.K.cast<Complex>());
  const int n = system.n_free();
  free_ = matrix_.topLeftCorner(n, n);
  scale_ = Eigen::VectorXd(n);
  for (int i = 0; i < n; ++i) scale_[i] = 1.;
  for (int column = 0; column < n; ++column)
    for (Matrix::InnerIterator entry(free_, column); entry; ++entry)
      if (entry.row() == entry.col() && std::abs(entry.value()) > 0.)
        scale_[column] = 1. / std::sqrt(std::abs(entry.value()));
  for (int column = 0; column < n; ++column)
    for (Matrix::InnerIterator entry(free_, column); entry; ++entry)
      entry.valueRef() *= scale_[entry.row()] * scale_[column];
  factors_.compute(free_);
  if (factors_.info() != Eigen::Success) throw std::runtime_error("singular");
}

ComplexVector FrequencyResponse::solve(const ComplexVector& right_side) const {
  const ComplexVector scaled = scale_.cast<Complex>().cwiseProduct(right_side);
  ComplexVector x = ComplexVector::Zero(system_.size());
  x.head(system_.n_free()) = scale_.cast<Complex>().cwiseProduct(ComplexVector(factors_.solve(scaled)));
  return x;
}

ComplexVector FrequencyResponse::operator()(const std::vector<Complex>& load) const {
  ComplexVector given = ComplexVector::Zero(system_.size()), right_side = given;
  for (std::size_t k = 0; k < load.size(); ++k) {
    const SystemLoad& system_load = system_.loads[k];
    if (system_load.prescribed >= 0)
      given[system_load.prescribed] = load[k] / Complex(0., omega_);
    else
      right_side += load[k] * system_load.vector;
  }
  right_side -= matrix_ * given;
  return solve(right_side.head(system_.n_free())) + given;
}

Complex FrequencyResponse::read(const Reading& reading, const ComplexVector& x,
                                const std::vector<Complex>& load) const {
  const Complex i_omega(0., omega_);
  Complex y = 0.;
  for (const auto& [i, weight] : reading.position) y += weight * x[i];
  for (const auto& [i, weight] : reading.velocity) y += weight * i_omega * x[i];
  for (const auto& [i, weight] : reading.acceleration) y += weight * i_omega * i_omega * x[i];
  for (std::size_t k = 0; k < reading.feedthrough.size(); ++k) y += reading.feedthrough[k] * load[k];
  return y;
}

}  // namespace upbead::test
