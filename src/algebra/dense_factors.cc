#include "algebra/dense_factors.h"

#include <petscsys.h>
// after petscsys.h, which it needs
#include <petscblaslapack.h>

#include <type_traits>
#include <utility>

#include "blas_turn.h"

extern "C" void dsymv_(const char* half, const PetscBLASInt* n, const double* factor, const double* A,
                       const PetscBLASInt* step_A, const double* x, const PetscBLASInt* step_x, const double* before,
                       double* y, const PetscBLASInt* step_y);

namespace upbead {

static_assert(std::is_same_v<PetscBLASInt, int>);

void DenseFactors::compute(Eigen::MatrixXd A) {
  factors_ = std::move(A);
  const auto n = static_cast<PetscBLASInt>(factors_.rows());
  pivots_.resize(static_cast<std::size_t>(n));
  PetscBLASInt info = 0;  // a zero on the diagonal makes solutions that are not finite
  const auto turn = detail::blas_turn();
  if (n > 0) LAPACKgetrf_(&n, &n, factors_.data(), &n, pivots_.data(), &info);
}

Eigen::VectorXd DenseFactors::solve(Eigen::VectorXd b) const {
  const auto n = static_cast<PetscBLASInt>(factors_.rows()), one = PetscBLASInt(1);
  PetscBLASInt info = 0;
  const auto turn = detail::blas_turn();
  if (n > 0) LAPACKgetrs_("N", &n, &one, factors_.data(), &n, pivots_.data(), b.data(), &n, &info);
  return b;
}

Eigen::VectorXd symmetric_product(const Eigen::MatrixXd& A, const Eigen::Ref<const Eigen::VectorXd>& x) {
  Eigen::VectorXd y(A.rows());
  const auto n = static_cast<PetscBLASInt>(A.rows()), next = PetscBLASInt(1);
  const double one = 1., zero = 0.;
  const auto turn = detail::blas_turn();
  if (n > 0) dsymv_("L", &n, &one, A.data(), &n, x.data(), &next, &zero, y.data(), &next);
  return y;
}

}  // namespace upbead
