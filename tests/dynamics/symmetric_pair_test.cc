// Claim: products by lower triangles equal those with the whole matrices: C v + K x, also where C or K lacks entries
// of the other, and quadratic forms by field. Tolerance: round-off of sums of a dozen terms of order 1.
#include "../../src/dynamics/products.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_system.h"

namespace symmetric_pair_test {

using namespace upbead;

TEST(SymmetricPair, EqualsTheProducts) {
  const System system = test::sample_system({});
  const SparseMatrix empty(system.size(), system.size());
  const Vector v = Vector::LinSpaced(system.size(), -1., 2.), x = v.array().sin(), f = v.array().cos();
  for (const auto& [C, K] : {std::pair(system.C, system.K), std::pair(system.K, system.C), std::pair(empty, system.C),
                             std::pair(system.C, empty)}) {
    Vector left = f;
    detail::SymmetricPair(C, K).subtract_products(v, x, left);
    EXPECT_LT((left - (f - C * v - K * x)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(LowerTriangle, HasTheGramsOfTheWhole) {
  const System system = test::sample_system({});
  for (const SparseMatrix& A : {system.M, system.C, system.K})
    for (const int columns : {1, 2, 3, 4, 6}) {
      detail::VectorBlock Z(system.size(), columns);
      for (int c = 0; c < columns; ++c) Z.col(c) = Vector::LinSpaced(system.size(), -1. - c, 2.).array().sin().matrix();
      const detail::FieldGrams found = detail::LowerTriangle(A, system.field).grams(Z, system.field);
      const Eigen::MatrixXd product = A * Eigen::MatrixXd(Z);
      for (const auto& [field, gram] :
           {std::pair(Field::displacement, found.displacement), std::pair(Field::relative_fluid, found.relative_fluid),
            std::pair(Field::pressure_impulse, found.pressure)}) {
        Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(columns, columns);
        for (int i = 0; i < system.size(); ++i)
          if (system.field[static_cast<std::size_t>(i)] == field)
            whole += (field == Field::pressure_impulse ? -1. : 1.) * Z.row(i).transpose() * product.row(i);
        EXPECT_LT((gram - whole).cwiseAbs().maxCoeff(), 1e-13 * (1. + whole.cwiseAbs().maxCoeff()));
      }
    }
  EXPECT_THROW(detail::LowerTriangle(system.K, system.field).grams(detail::VectorBlock(system.size(), 5), system.field),
               std::logic_error);
}

}  // namespace symmetric_pair_test
