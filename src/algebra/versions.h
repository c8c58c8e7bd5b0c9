// Versions of the libraries for linear algebra.
#pragma once

#include "base/version.h"

namespace upbead {

/// Versions of PETSc, CHOLMOD, Eigen, MPI, and of the BLAS that this process found when it started.
Versions algebra_versions();

}  // namespace upbead
