// The matrix of shared unknowns by PETSc and MUMPS.
#pragma once

#include <petscmat.h>

#include <exception>

#include "algebra/shared_matrix.h"
#include "upbead/algebra/processes.h"

namespace upbead::detail {

/// Owns an object of PETSc, which all processes destroy together. Where an exception ends the work of this process, the
/// others may not come to that: the object is left to the end of all processes.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class OfPetsc {
 public:
  OfPetsc() = default;
  ~OfPetsc() {
    if (std::uncaught_exceptions() == 0) clear();
  }
  OfPetsc(const OfPetsc&) = delete;
  OfPetsc& operator=(const OfPetsc&) = delete;

  operator Object() const { return object_; }  // NOLINT(google-explicit-constructor): as PETSc's functions take it
  /// Where PETSc is to write a new object.
  Object* place() { return &object_; }
  void clear() {
    if (object_ != nullptr) destroy(&object_);
    object_ = nullptr;
  }

 private:
  Object object_ = nullptr;
};

/// The parts are summed by a MATIS, and factorised by MUMPS (Amestoy, Duff, L'Excellent & Koster, SIAM J. Matrix Anal.
/// Appl. 23 (2001) 15) as L D L^T with pivots of 1 x 1 and 2 x 2, distributed over all processes.
class MumpsMatrix : public SharedMatrix {
 public:
  explicit MumpsMatrix(const Sharing& sharing);

  void factorise(const std::vector<double>& part) override;
  void solve(double* x) const override;
  int n_negative() const override { return n_negative_; }

 private:
  void sum(const std::vector<double>& part);
  void analyse();
  void check_factor();

  PetscInt n_;  ///< shared unknowns of this process
  OfPetsc<ISLocalToGlobalMapping, ISLocalToGlobalMappingDestroy> numbers_;
  OfPetsc<Mat, MatDestroy> sum_, factor_;
  OfPetsc<Vec, VecDestroy> here_, b_, x_;  ///< `here_` is laid over a part of a right-hand side
  OfPetsc<VecScatter, VecScatterDestroy> scatter_;
  int n_negative_ = 0;
};

}  // namespace upbead::detail
