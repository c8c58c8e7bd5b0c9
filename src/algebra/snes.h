// What every non-linear solver of PETSc is asked in the same way.
#pragma once

#include <petscsnes.h>

#include <exception>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// Throws NumericsError where PETSc reports an error.
void check_snes(PetscErrorCode error);

/// Between vectors of one length. Return PETSc's errors, so that functions that PETSc calls can hand them on.
PetscErrorCode copy(Vec from, Vector& to);
PetscErrorCode copy(const Vector& from, Vec to);

struct SnesReport {
  double residual = 0.;  ///< |F| at the end
  bool converged = false;
};

/// From x on until |F(x)| <= tolerance; `at` is the solver's own vector. `thrown`: where its functions keep what they
/// throw, which may not pass through PETSc; it is thrown here. Throws NumericsError where PETSc fails otherwise.
SnesReport solve_snes(SNES snes, Vec at, Vector& x, double tolerance, std::exception_ptr& thrown);

}  // namespace upbead
