// Products of a march with the matrices of its system.
#pragma once

#include <vector>

#include "upbead/algebra/sparse.h"
#include "upbead/system/system.h"

namespace upbead::detail {

/// The lower triangles of C and K on their common pattern: one pass through half of the entries gives C v + K x,
/// where two separate products would read 1.7 times as many bytes.
class SymmetricPair {
 public:
  SymmetricPair(const SparseMatrix& C, const SparseMatrix& K);
  /// f -= C v + K x; all of the matrices' size.
  void subtract_products(const Vector& v, const Vector& x, Vector& f) const;

 private:
  using Pair = Eigen::Array2d;  ///< of C and v, and of K and x
  std::vector<int> begin_;      ///< of each row in `column_` and `entry_`; their number at the end
  std::vector<int> column_;     ///< left of the diagonal
  std::vector<Pair> entry_;
  std::vector<Pair> diagonal_;
  mutable std::vector<Pair> vectors_, products_;
};

/// A few vectors side by side, one per column, stored row by row so that a matrix is read once for all of them.
using VectorBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A X.
VectorBlock block_product(const SparseMatrix& A, const VectorBlock& X);

/// Z^T J A Z, rows of J A summed over the unknowns of each field; J = -1 on phi, +1 elsewhere.
struct FieldGrams {
  Eigen::MatrixXd displacement, relative_fluid, pressure;
  Eigen::MatrixXd total() const { return displacement + relative_fluid + pressure; }
};

/// The entries below the diagonal of a symmetric A, by the field of their columns: a gram needs to read only half of
/// A.
class LowerTriangle {
 public:
  LowerTriangle(const SparseMatrix& A, const std::vector<Field>& field);
  /// The grams of Z (n x 1, 2, 3, 4 or 6); throws std::logic_error for another number of columns.
  FieldGrams grams(const VectorBlock& Z, const std::vector<Field>& field) const;

 private:
  template <int n_columns>
  FieldGrams grams_of(const VectorBlock& Z, const std::vector<Field>& field) const;

  std::vector<int> begin_;   ///< of each row and field in `column_` and `entry_`; their number at the end
  std::vector<int> column_;  ///< left of the diagonal
  std::vector<double> entry_;
  Vector diagonal_;
};

}  // namespace upbead::detail
