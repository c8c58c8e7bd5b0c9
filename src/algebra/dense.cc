#include "algebra/dense.h"

#include <petscsys.h>
// after petscsys.h, which it needs
#include <petscblaslapack.h>

#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include "blas_turn.h"

extern "C" void zgesv_(const PetscBLASInt* n, const PetscBLASInt* n_columns, std::complex<double>* A,
                       const PetscBLASInt* step_A, PetscBLASInt* pivots, std::complex<double>* B,
                       const PetscBLASInt* step_B, PetscBLASInt* info);

namespace upbead {

namespace {

using Columns = Eigen::Ref<const Eigen::MatrixXd>;

Eigen::MatrixXd product_of(const Columns& A, bool transposed, const Columns& B) {
  Eigen::MatrixXd C(transposed ? A.cols() : A.rows(), B.cols());
  const auto int_of = [](Eigen::Index n) { return static_cast<PetscBLASInt>(n); };
  const PetscBLASInt rows = int_of(C.rows()), columns = int_of(C.cols()), inner = int_of(B.rows());
  const PetscBLASInt step_A = int_of(A.outerStride()), step_B = int_of(B.outerStride());
  if (C.size() == 0) return C;
  if (inner == 0) return C.setZero();
  const double one = 1., zero = 0.;
  const auto turn = detail::blas_turn();
  if (columns == 1) {
    const PetscBLASInt rows_A = int_of(A.rows()), columns_A = int_of(A.cols()), next = 1;
    BLASgemv_(transposed ? "T" : "N", &rows_A, &columns_A, &one, A.data(), &step_A, B.data(), &next, &zero, C.data(),
              &next);
    return C;
  }
  BLASgemm_(transposed ? "T" : "N", "N", &rows, &columns, &inner, &one, A.data(), &step_A, B.data(), &step_B, &zero,
            C.data(), &rows);
  return C;
}

/// X of A X = B, by that routine.
template <class Matrix, class Routine>
Matrix solved(const Routine& gesv, Matrix A, Matrix B) {
  if (A.rows() == 0) return B;
  const auto n = static_cast<PetscBLASInt>(A.rows()), n_columns = static_cast<PetscBLASInt>(B.cols());
  PetscBLASInt info = 0;
  std::vector<PetscBLASInt> pivots(static_cast<std::size_t>(n));
  const auto turn = detail::blas_turn();
  gesv(&n, &n_columns, A.data(), &n, pivots.data(), B.data(), &n, &info);
  if (info != 0) B.setConstant(std::numeric_limits<double>::quiet_NaN());
  return B;
}

}  // namespace

Eigen::MatrixXd product(const Columns& A, const Columns& B) {
  return product_of(A, false, B);
}

Eigen::MatrixXd transposed_product(const Columns& A, const Columns& B) {
  return product_of(A, true, B);
}

Eigen::MatrixXd solve_dense(Eigen::MatrixXd A, Eigen::MatrixXd B) {
  return solved(LAPACKgesv_, std::move(A), std::move(B));
}

Eigen::MatrixXcd solve_complex(Eigen::MatrixXcd A, Eigen::MatrixXcd B) {
  return solved(zgesv_, std::move(A), std::move(B));
}

}  // namespace upbead
