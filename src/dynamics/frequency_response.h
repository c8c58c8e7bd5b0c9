// The whole state of a reduced system at complex frequencies.
#pragma once

#include <complex>
#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/dynamics/reduced_system.h"

namespace upbead {

/// Laplace transforms F_k(s) = int_0^T f_k exp(-s t) dt of all loads over their samples; exact, as loads are
/// straight between samples. s is not 0.
Eigen::VectorXcd laplace_transform(const SampledLoads& loads, std::complex<double> s);

/// The coordinates of X(s), below, a column for each of F; rows F_k of the loads.
Eigen::MatrixXcd coordinates_at(const ReducedSystem& reduced, std::complex<double> s, const Eigen::MatrixXcd& F);

/// X(s) with (s^2 M + s C + K) X = sum_k b_k F_k, one entry for each unknown of the system, by projection on the
/// Krylov space; s X_p = F_k of prescribed unknowns.
Eigen::VectorXcd frequency_response(const SecondOrderKrylov& krylov, const ReducedSystem& reduced,
                                    std::complex<double> s, const Eigen::VectorXcd& F);

}  // namespace upbead
