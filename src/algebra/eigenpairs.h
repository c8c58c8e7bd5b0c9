// Eigenvalues and eigenvectors of a dense matrix.
#pragma once

#include <Eigen/Core>

namespace upbead {

/// A X = X diag(value); conjugate pairs stand side by side, the one with positive imaginary part first.
struct Eigenpairs {
  Eigen::VectorXcd value;
  Eigen::MatrixXcd vector;  ///< by column, of length 1
};

/// By LAPACK's dgeev. Throws NumericsError where it does not converge.
Eigenpairs eigenpairs(Eigen::MatrixXd A);

}  // namespace upbead
