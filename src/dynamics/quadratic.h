// Quadratic forms of a system's matrices, split by the kind of unknown.
#pragma once

#include "upbead/system/system.h"

namespace upbead::detail {

/// A few vectors side by side, one per column, stored row by row so that a matrix is read once for all of them.
using VectorBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Z^T J A Z, rows of J A summed over the unknowns of each field; J = -1 on phi, +1 elsewhere.
struct FieldGrams {
  Eigen::MatrixXd displacement, relative_fluid, pressure;
  Eigen::MatrixXd total() const { return displacement + relative_fluid + pressure; }
};

/// The grams of Z (n x 1, 2, 3, 4 or 6); throws std::logic_error for another number of columns.
FieldGrams grams(const SparseMatrix& A, const VectorBlock& Z, const std::vector<Field>& field);

}  // namespace upbead::detail
