// Claim: the pass through the lower triangles of C and K gives what the products with the whole matrices give, whatever
// entries either lacks. Tolerance: round-off of sums of a dozen terms of order 1.
#include "../../src/dynamics/products.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_system.h"

namespace {

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

}  // namespace
