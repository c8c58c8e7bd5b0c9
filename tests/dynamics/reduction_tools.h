// Tools for tests of reduced systems: the whole system as a reduced one, transfer functions, marches to compare with.
#pragma once

#include <complex>

#include "sample_system.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/dynamics/reduced_system.h"

namespace upbead::test {

/// All unknowns of a system as coordinates, in another order.
ReducedSystem whole(const System& system, double shift);
/// The system projected on at most `most_vectors` vectors.
ReducedSystem reduced(const System& system, double shift, int most_vectors = 1000);
/// In modes.
ModalModel modes_of(const ReducedSystem& reduced);

/// H(s) = Y/F, readings x loads, by a dense solve; where phi is not determined, the smallest solution.
Eigen::MatrixXcd transfer(const ReducedSystem& reduced, std::complex<double> s);
Eigen::MatrixXcd transfer(const ModalModel& model, std::complex<double> s);
/// Norm of the difference over that of `expected`.
double relative(const Eigen::MatrixXcd& found, const Eigen::MatrixXcd& expected);

/// The sample with three loads on u, W and phi that are independent, and readings of every kind.
System loaded_sample(const Sample& sample, const TimeFunction& history);
/// A column of n cells on a rigid base, u at its nodes and phi in its cells, under a load at its top; waves pass a
/// cell in about a unit of time. Readings "top" and "pressure".
System chain(int n, double storage, double darcy, double damping);

/// Rises to 1 and falls to 0 within [0, 2].
TimeFunction hat();
/// SDIRK in n equal steps.
Series marched(const System& system, double end, int n);
/// The model under the system's loads at these times.
Eigen::MatrixXd responded(const ModalModel& model, const System& system, const std::vector<double>& time);
/// Largest difference over time of the readings, each over its largest value.
double error(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected);

}  // namespace upbead::test
