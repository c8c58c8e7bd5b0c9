// What linear algebra is done with.
#pragma once

#include "base/version.h"

namespace upbead {

/// Of PETSc, CHOLMOD, Eigen, MPI, and of the BLAS that this process found when it started.
Versions algebra_versions();

}  // namespace upbead
