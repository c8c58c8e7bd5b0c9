// What rows over the unknowns of a scene read, by coordinate of a basis.
#pragma once

#include <Eigen/Core>

#include "upbead/algebra/sparse.h"
#include "upbead/dynamics/krylov.h"

namespace upbead {

/// A row for each of `rows`, a column for each direction of the basis. Values at many times are this times the
/// coordinates: far less work than all unknowns at all times where there are few directions.
Eigen::MatrixXd rows_of_basis(const SparseMatrix& rows, const FieldBasis& basis);

}  // namespace upbead
