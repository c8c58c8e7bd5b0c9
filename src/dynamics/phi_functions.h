// Exponentials of an exact integrator.
#pragma once

#include <complex>

namespace upbead::detail {

/// e^x, phi_1 = (e^x - 1)/x and phi_2 = (e^x - 1 - x)/x^2, by which z' = pole z + f goes from z_0 to
/// e^x z_0 + h (phi_1 f_0 + phi_2 (f_1 - f_0)) in a step h, where x = pole h and f is a line from f_0 to f_1.
struct PhiFunctions {
  std::complex<double> exp, phi1, phi2;
};

/// For Re x <= 0, with errors of a few roundings of 1; phi_1 is never 0.
PhiFunctions phi_functions(const std::complex<double>& x);

/// phi_3 = (phi_2 - 1/2)/x, for the integral of z.
std::complex<double> phi3(const std::complex<double>& x, const std::complex<double>& phi2);

}  // namespace upbead::detail
