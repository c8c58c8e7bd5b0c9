// A line search where the function of a non-linear solver is the slope of a convex one.
#pragma once

#include <petscsnes.h>

namespace upbead {

/// For PETSc's line search "shell". The solver's function at x - length y times y is the slope along the step y, and
/// falls as the length grows; the length is sought at which little of it is left. Returns PETSc's errors.
PetscErrorCode step_to_least(SNESLineSearch search, void* unused);

}  // namespace upbead
