// Dense matrices by LAPACK and BLAS, which use the widest vector registers of the processor.
#pragma once

#include <Eigen/Core>

namespace upbead {

/// X of A X = B, by dgesv; not finite where A is singular.
Eigen::MatrixXd solve_dense(Eigen::MatrixXd A, Eigen::MatrixXd B);
/// The same of complex numbers, by zgesv.
Eigen::MatrixXcd solve_complex(Eigen::MatrixXcd A, Eigen::MatrixXcd B);

/// A B, by dgemm or dgemv.
Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::MatrixXd>& B);
/// A^T B, likewise.
Eigen::MatrixXd transposed_product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                   const Eigen::Ref<const Eigen::MatrixXd>& B);

}  // namespace upbead
