// P A P^T = L D L^T of one sparse symmetric matrix, over PETSc.
#pragma once

#include <petscmat.h>

#include "upbead/algebra/factorisation.h"

namespace upbead::detail {

/// L D L^T without pivoting of a symmetric quasi-definite matrix (both triangles stored, columns ascending, every
/// diagonal entry stored), unknowns ordered by minimum degree or nested dissection.
class Ldlt {
 public:
  /// Orders the unknowns and finds the pattern of L; `A` is kept by reference and must outlive this object. Throws
  /// NumericsError where PETSc fails, std::logic_error where there is no PetscSession.
  explicit Ldlt(SparseMatrix& A);
  ~Ldlt();
  Ldlt(const Ldlt&) = delete;
  Ldlt& operator=(const Ldlt&) = delete;

  /// Factorises the present values of A. Throws NumericsError on a zero pivot or one that is not finite.
  void factorise();
  /// x = A^-1 b; b and x are different vectors of A's size.
  void solve(const Vector& b, Vector& x) const;
  Inertia inertia() const;
  long n_factor_entries() const;

 private:
  int size_;
  Mat matrix_ = nullptr;
  Mat factor_ = nullptr;
  IS order_ = nullptr;
  Vec rhs_ = nullptr;
  Vec solution_ = nullptr;
};

}  // namespace upbead::detail
