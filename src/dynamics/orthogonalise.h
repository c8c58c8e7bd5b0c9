// Orthonormal directions of a Krylov space, one at a time.
#pragma once

#include "algebra/dense.h"
#include "upbead/dynamics/krylov.h"

namespace upbead::detail {

/// Share of a vector's length that round-off may leave where the vector lies in the span of others.
constexpr double round_off = 1e-11;

/// Subtracts from y its part in the span of the orthonormal columns of Q, twice, as once is not enough near the span;
/// returns the coordinates of the part subtracted.
inline Vector orthogonalise(const Eigen::Ref<const Eigen::MatrixXd>& Q, Vector& y, const Layout& layout = {}) {
  Vector coordinates = Vector::Zero(Q.cols());
  for (int pass = 0; pass < 2; ++pass) {
    const Vector h = layout.products(Q, y);
    y -= product(Q, h);
    coordinates += h;
  }
  return coordinates;
}

inline void add_column(FieldBasis& basis, const Vector& column, int coordinate) {
  if (basis.n() == basis.vectors.cols()) basis.vectors.conservativeResize(Eigen::NoChange, 2 * basis.n());
  basis.vectors.col(basis.n()) = column;
  basis.coordinate.push_back(coordinate);
}

/// The parts of exact_bases(): bases without directions, and one unknown more that is kept.
FieldBases empty_bases(const System& system, const SparseMatrix& T);
void keep_unknown(const System& system, int unknown, FieldBases& bases);

}  // namespace upbead::detail
