// Dense matrices that are used many times, by LAPACK and BLAS.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace upbead {

/// Factors of a square A, by dgetrf.
class DenseFactors {
 public:
  void compute(Eigen::MatrixXd A);
  /// x of A x = b; not finite where A is singular.
  Eigen::VectorXd solve(Eigen::VectorXd b) const;

 private:
  Eigen::MatrixXd factors_;
  std::vector<int> pivots_;
};

/// A x of a symmetric A, whose lower half is read, by dsymv.
Eigen::VectorXd symmetric_product(const Eigen::MatrixXd& A, const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace upbead
