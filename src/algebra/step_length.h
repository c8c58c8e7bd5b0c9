// A line search where the function of a non-linear solver is the gradient of a convex function.
#pragma once

#include <petscsnes.h>

namespace upbead {

/// For PETSc's line search "shell". The solver's function at x - length y, times y, is the slope along the step y; it
/// falls as the length grows. Finds a length at which the slope is small. Returns PETSc's errors.
PetscErrorCode step_to_least(SNESLineSearch search, void* unused);

}  // namespace upbead
