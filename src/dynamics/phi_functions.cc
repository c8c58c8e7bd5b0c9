#include "phi_functions.h"

#include <cmath>

namespace upbead::detail {

namespace {

/// k! phi_k by its power series, for |x| <= 1, where the closed form cancels: 1 + x/(k+1) + x^2/((k+1)(k+2)) + ...
std::complex<double> series(const std::complex<double>& x, int k) {
  constexpr int n_terms = 18;  // 1/20! is below round-off of 1/2
  std::complex<double> sum = 1.;
  for (int n = n_terms + k; n > k; --n) sum = 1. + sum * x / static_cast<double>(n);
  return sum;
}

}  // namespace

PhiFunctions phi_functions(const std::complex<double>& x) {
  const std::complex<double> exp = std::exp(x);
  if (std::abs(x) > 1.) {
    const std::complex<double> phi1 = (exp - 1.) / x;
    return {exp, phi1, (phi1 - 1.) / x};
  }
  const std::complex<double> phi2 = 0.5 * series(x, 2);
  return {exp, 1. + x * phi2, phi2};
}

std::complex<double> phi3(const std::complex<double>& x, const std::complex<double>& phi2) {
  if (std::abs(x) > 1.) return (phi2 - 0.5) / x;
  return series(x, 3) / 6.;
}

}  // namespace upbead::detail
