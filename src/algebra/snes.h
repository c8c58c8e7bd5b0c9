// What all non-linear solvers by PETSc share.
#pragma once

#include <petscsnes.h>

#include <exception>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// Throws NumericsError where PETSc reports an error.
void check_snes(PetscErrorCode error);

/// Copies between vectors of one length. Returns PETSc's errors, so that functions called by PETSc can pass them on.
PetscErrorCode copy(Vec from, Vector& to);
PetscErrorCode copy(const Vector& from, Vec to);

struct SnesReport {
  double residual = 0.;  ///< |F| at the end
  bool converged = false;
};

/// Iterates from x until |F(x)| <= tolerance; `at` is the solver's own vector. `thrown`: an exception of the solver's
/// functions, which must not pass through PETSc; it is thrown here. Throws NumericsError where PETSc fails otherwise.
SnesReport solve_snes(SNES snes, Vec at, Vector& x, double tolerance, std::exception_ptr& thrown);

}  // namespace upbead
