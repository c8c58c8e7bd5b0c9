#include "phi_functions.h"

#include <cmath>

namespace upbead::detail {

namespace {

/// phi_2 by its power series, for |x| <= 1, where the closed form cancels: 1/2 + x/3! + x^2/4! + ...
std::complex<double> phi2_series(const std::complex<double>& x) {
  constexpr int n_terms = 18;  // 1/20! is below round-off of 1/2
  std::complex<double> sum = 1.;
  for (int k = n_terms + 2; k > 2; --k) sum = 1. + sum * x / static_cast<double>(k);
  return 0.5 * sum;
}

}  // namespace

PhiFunctions phi_functions(const std::complex<double>& x) {
  const std::complex<double> exp = std::exp(x);
  if (std::abs(x) > 1.) {
    const std::complex<double> phi1 = (exp - 1.) / x;
    return {exp, phi1, (phi1 - 1.) / x};
  }
  const std::complex<double> phi2 = phi2_series(x);
  return {exp, 1. + x * phi2, phi2};
}

std::complex<double> phi3(const std::complex<double>& x, const std::complex<double>& phi2) {
  if (std::abs(x) > 1.) return (phi2 - 0.5) / x;
  constexpr int n_terms = 18;
  std::complex<double> sum = 1.;
  for (int k = n_terms + 3; k > 3; --k) sum = 1. + sum * x / static_cast<double>(k);
  return sum / 6.;
}

}  // namespace upbead::detail
