#include "algebra/mumps_matrix.h"

#include <string>

#include "algebra/ldlt/signed_cholesky.h"
#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

void check_mumps(PetscErrorCode error) {
  if (error != 0)
    throw NumericsError("PETSc cannot solve for the unknowns that several processes share (its error " +
                        std::to_string(error) + ")");
}

}  // namespace

MumpsMatrix::MumpsMatrix(const Sharing& sharing) : n_(static_cast<PetscInt>(sharing.numbers.size())) {
  const PetscInt n_all = sharing.n_all;
  const std::vector<PetscInt> numbers(sharing.numbers.begin(), sharing.numbers.end());
  check_mumps(
      ISLocalToGlobalMappingCreate(PETSC_COMM_WORLD, 1, n_, numbers.data(), PETSC_COPY_VALUES, numbers_.place()));
  check_mumps(VecCreateMPI(PETSC_COMM_WORLD, PETSC_DECIDE, n_all, b_.place()));
  check_mumps(VecDuplicate(b_, x_.place()));
  check_mumps(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n_, nullptr, here_.place()));
  OfPetsc<IS, ISDestroy> places;
  check_mumps(ISCreateGeneral(PETSC_COMM_SELF, n_, numbers.data(), PETSC_COPY_VALUES, places.place()));
  check_mumps(VecScatterCreate(b_, places, here_, nullptr, scatter_.place()));
}

void MumpsMatrix::sum(const std::vector<double>& part) {
  OfPetsc<Mat, MatDestroy> parts, own;
  PetscInt n_all = 0, n_rows = 0;
  check_mumps(VecGetSize(b_, &n_all));
  check_mumps(VecGetLocalSize(b_, &n_rows));
  check_mumps(MatCreateIS(PETSC_COMM_WORLD, 1, n_rows, n_rows, n_all, n_all, numbers_, numbers_, parts.place()));
  check_mumps(MatCreateSeqDense(PETSC_COMM_SELF, n_, n_, const_cast<double*>(part.data()), own.place()));
  check_mumps(MatISSetLocalMat(parts, own));
  check_mumps(MatAssemblyBegin(parts, MAT_FINAL_ASSEMBLY));
  check_mumps(MatAssemblyEnd(parts, MAT_FINAL_ASSEMBLY));
  check_mumps(MatConvert(parts, MATSBAIJ, sum_ == nullptr ? MAT_INITIAL_MATRIX : MAT_REUSE_MATRIX, sum_.place()));
  check_mumps(MatSetOption(sum_, MAT_SYMMETRIC, PETSC_TRUE));
}

/// Options of the user come after these settings, and override them.
void MumpsMatrix::analyse() {
  check_mumps(MatGetFactor(sum_, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor_.place()));
  check_mumps(MatMumpsSetIcntl(factor_, 8, 0));           // no scaling: the matrix is equilibrated
  check_mumps(MatMumpsSetIcntl(factor_, 13, 1));          // no ScaLAPACK: INFOG(12) lacks its pivots
  check_mumps(MatMumpsSetIcntl(factor_, 14, 300));        // room: the estimate (%) falls short by far
  check_mumps(MatMumpsSetIcntl(factor_, 24, 1));          // zero pivots are counted
  check_mumps(MatMumpsSetCntl(factor_, 3, -zero_pivot));  // < 0: absolute
  check_mumps(MatCholeskyFactorSymbolic(factor_, sum_, nullptr, nullptr));
}

void MumpsMatrix::check_factor() {
  MatFactorError error = MAT_FACTOR_NOERROR;
  PetscInt status = 0, n_zero = 0;
  check_mumps(MatFactorGetError(factor_, &error));
  check_mumps(MatMumpsGetInfog(factor_, 1, &status));
  check_mumps(MatMumpsGetInfog(factor_, 28, &n_zero));
  if (n_zero == 0 && error == MAT_FACTOR_NOERROR) return;
  factor_.clear();  // PETSc would not factorise other values with it
  if (n_zero > 0 || error == MAT_FACTOR_NUMERIC_ZEROPIVOT)
    throw NumericsError(
        "the matrix is singular in unknowns that several processes share (is a part of the scene not held, or a "
        "pressure nowhere given?)");
  throw NumericsError("MUMPS cannot factorise the unknowns that several processes share: its INFOG(1) is " +
                      std::to_string(status) + " (more room, at -8 and -9: --petsc \"-mat_mumps_icntl_14 1000\")");
}

void MumpsMatrix::factorise(const std::vector<double>& part) {
  sum(part);
  if (factor_ == nullptr) analyse();
  check_mumps(MatCholeskyFactorNumeric(factor_, sum_, nullptr));
  check_factor();
  PetscInt negative = 0;
  check_mumps(MatMumpsGetInfog(factor_, 12, &negative));
  n_negative_ = static_cast<int>(negative);
}

void MumpsMatrix::solve(double* x) const {
  check_mumps(VecPlaceArray(here_, x));
  check_mumps(VecZeroEntries(b_));
  check_mumps(VecScatterBegin(scatter_, here_, b_, ADD_VALUES, SCATTER_REVERSE));
  check_mumps(VecScatterEnd(scatter_, here_, b_, ADD_VALUES, SCATTER_REVERSE));
  check_mumps(MatSolve(factor_, b_, x_));
  check_mumps(VecScatterBegin(scatter_, x_, here_, INSERT_VALUES, SCATTER_FORWARD));
  check_mumps(VecScatterEnd(scatter_, x_, here_, INSERT_VALUES, SCATTER_FORWARD));
  check_mumps(VecResetArray(here_));
}

}  // namespace upbead::detail
