// Products and Cholesky factors of dense matrices of up to a few hundred rows, with the widest registers of a machine.
// Their numbers of rows and columns are padded() by zeros.
#pragma once

#include <Eigen/Core>

namespace upbead {

/// A whole number of registers.
Eigen::Index padded(Eigen::Index rows);

/// The lower triangle of C += A A', from the row and column `at` of C on; above its diagonal anything.
void add_products(const Eigen::MatrixXd& A, Eigen::Index at, Eigen::MatrixXd& C);

/// x of A x + b = 0, of the lower triangle of A and b' as the row below it in its first n + 1 rows and columns, which
/// are overwritten. Empty where A is not positive definite.
Eigen::VectorXd solve_positive(Eigen::MatrixXd& A_and_b, Eigen::Index n);

}  // namespace upbead
