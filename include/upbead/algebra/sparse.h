// The sparse matrices and vectors of the whole program.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace upbead {

using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Indices [begin, end).
struct IndexRange {
  int begin = 0;
  int end = 0;
  int size() const { return end - begin; }
};

}  // namespace upbead
