#include "response/rows_of_basis.h"

namespace upbead {

Eigen::MatrixXd rows_of_basis(const SparseMatrix& rows, const FieldBasis& basis) {
  SparseMatrix chosen(rows.cols(), static_cast<Eigen::Index>(basis.unknown.size()));
  for (std::size_t j = 0; j < basis.unknown.size(); ++j)
    chosen.coeffRef(basis.unknown[j], static_cast<Eigen::Index>(j)) = 1.;
  const Eigen::MatrixXd vectors = basis.unit.asDiagonal() * basis.columns();
  return SparseMatrix(rows * chosen) * vectors;
}

}  // namespace upbead
