// Claims: a space of m vectors for each load gives T(s)^-1 b to round-off at s_0 and elsewhere with an error of order
// m in s - s_0, of order 2 m where the reading is the load's own displacement; the bases are orthonormal in their
// units; prescribed and kept unknowns are coordinates; loads that are sums of other loads add no vectors; a system
// that cannot be reduced is refused.
// Source: Bai and Su (2005): Galerkin projection on r_0 ... r_(m-1) keeps m moments, of symmetric transfers 2 m.
#include "upbead/dynamics/krylov.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "reduction_tools.h"
#include "upbead/base/error.h"

namespace krylov_test {

using namespace upbead;
using namespace upbead::test;

constexpr double shift = 0.8;

const Sample variants[] = {
    {1., 1.}, {1., 0.}, {0., 1.}, {0., 0.}, {1., 1., 1., 0.1, true}, {1., 1., 1., 0.1, false, true}};

/// Slope of |H_m(s) - H(s)| over |s - s_0|, both in logarithms.
double slope(const System& system, int vectors, int reading, int load) {
  const ReducedSystem all = whole(system, shift), some = reduced(system, shift, vectors);
  std::vector<int> n;
  std::vector<double> difference;
  for (const int i : {32, 24, 16, 12}) {
    const double s = shift * (1. + 0.5 / i);
    n.push_back(i);
    difference.push_back(std::abs(transfer(some, s)(reading, load) - transfer(all, s)(reading, load)));
  }
  return order(n, difference);
}

TEST(Krylov, IsExactAtTheShift) {
  for (const Sample& sample : variants) {
    System system = loaded_sample(sample, hat());
    if (system.n_prescribed > 0) system.loads.push_back(prescribed_load(system, hat()));
    const int starts = static_cast<int>(system.loads.size());
    Eigen::MatrixXcd found = transfer(reduced(system, shift, starts), shift);
    Eigen::MatrixXcd expected = transfer(whole(system, shift), shift);
    // Without storage and seepage phi is the multiplier that keeps the volume constant: in a space of u without
    // change of volume, phi is not determined.
    const Eigen::Index rows = expected.rows() - (sample.storage + sample.darcy == 0. ? 1 : 0);
    EXPECT_LT(relative(found.topRows(rows), expected.topRows(rows)), 1e-12);
  }
  const System large = chain(40, 1., 0.5, 0.1);
  EXPECT_LT(relative(transfer(reduced(large, shift, 2), shift), transfer(whole(large, shift), shift)), 1e-12);
}

TEST(Krylov, KeepsMomentsOfEveryReading) {
  const System system = chain(40, 1., 0.5, 0.1);
  for (const int m : {2, 3, 4}) EXPECT_GT(slope(system, m, 1, 0), m - 0.2) << m << " vectors";
}

TEST(Krylov, KeepsTwiceTheMomentsOfALoadsOwnDisplacement) {
  const System system = chain(40, 1., 0.5, 0.1);
  for (const int m : {1, 2, 3}) EXPECT_GT(slope(system, m, 0, 0), 2 * m - 0.2) << m << " vectors";
}

TEST(Krylov, KeepsMomentsOfEveryLoad) {
  System system = chain(40, 1., 0.5, 0.1);
  system.loads.push_back({"middle", Vector::Unit(80, 17), hat(), -1});
  for (const int m : {2, 3})
    for (const int load : {0, 1}) EXPECT_GT(slope(system, 2 * m, 1, load), m - 0.2) << m << " vectors, load " << load;
}

TEST(Krylov, LoadsThatAreSumsStartNothing) {
  for (const bool prescribed : {false, true}) {
    Sample sample;
    sample.prescribed_u = prescribed;
    System system = loaded_sample(sample, hat());
    SystemLoad sum = system.loads[0], none = sum;
    sum.vector = 2. * system.loads[0].vector - 0.5 * system.loads[1].vector;
    none.vector.setZero();
    system.loads.insert(system.loads.begin() + 2, {sum, none});
    if (prescribed) system.loads.insert(system.loads.end(), 2, prescribed_load(system, hat()));
    const SecondOrderKrylov krylov(system, shift);
    EXPECT_EQ(krylov.n_independent_loads(), prescribed ? 4 : 3);
    EXPECT_EQ(krylov.n_vectors(), krylov.n_independent_loads());
    EXPECT_EQ(krylov.n_solves(), krylov.n_independent_loads());
    const ReducedSystem some = reduced(system, shift, krylov.n_independent_loads());
    EXPECT_LT(relative(transfer(some, shift), transfer(whole(system, shift), shift)), 1e-12);
  }
}

TEST(Krylov, BasesAreOrthonormalAndHoldWhatIsKept) {
  Sample sample;
  sample.prescribed_u = true;
  System system = loaded_sample(sample, hat());
  const std::vector<int> exact{3, 12};  // a u and a phi
  SecondOrderKrylov krylov(system, shift, exact);
  while (krylov.extend()) continue;
  EXPECT_EQ(krylov.n_coordinates(), system.size());
  for (const FieldBasis* basis : {&krylov.displacements(), &krylov.phi()}) {
    const Eigen::MatrixXd V = basis->columns();
    EXPECT_LT((V.transpose() * V - Eigen::MatrixXd::Identity(V.cols(), V.cols())).norm(), 1e-13);
  }
  const FieldBasis& u = krylov.displacements();
  EXPECT_EQ(u.coordinate[0], 0) << "the prescribed unknown comes first";
  EXPECT_EQ(u.unknown.back(), system.size() - 1);
  EXPECT_EQ(u.vectors(u.vectors.rows() - 1, 0), 1.);
  EXPECT_EQ(u.vectors(3, 1), 1.);
  EXPECT_EQ(krylov.phi().vectors(2, 0), 1.);
  EXPECT_FALSE(krylov.extend()) << "once exhausted, always exhausted";
}

/// Largest part of a direction of one basis that the other does not hold.
double beyond(const FieldBasis& one, const FieldBasis& other) {
  const Eigen::MatrixXd Q = other.columns(), V = one.columns();
  if (V.size() == 0) return 0.;
  return (V - Q * (Q.transpose() * V)).colwise().norm().maxCoeff();
}

TEST(Krylov, SideBySideSpansTheSame) {
  System system = chain(40, 1., 0.5, 0.1);
  system.loads.push_back({"middle", Vector::Unit(80, 17), hat(), -1});
  SecondOrderKrylov one(system, shift, {5}), together(system, shift, {5});
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(together.extend_together());
  while (one.n_vectors() < together.n_vectors()) ASSERT_TRUE(one.extend());
  EXPECT_EQ(together.n_vectors(), 8);
  EXPECT_EQ(together.n_solves(), one.n_solves());
  for (const auto& [a, b] :
       {std::pair(&one.displacements(), &together.displacements()), {&one.phi(), &together.phi()}}) {
    ASSERT_EQ(a->n(), b->n());
    EXPECT_LT(beyond(*a, *b), 1e-9);
    EXPECT_LT(beyond(*b, *a), 1e-9);
  }
}

TEST(Krylov, SideBySideEndsWhereTheSpaceIsExhausted) {
  for (const bool prescribed : {false, true}) {
    Sample sample;
    sample.prescribed_u = prescribed;
    System system = loaded_sample(sample, hat());
    if (prescribed) system.loads.push_back(prescribed_load(system, hat()));
    SecondOrderKrylov krylov(system, shift);
    while (krylov.extend_together()) continue;
    EXPECT_EQ(krylov.n_coordinates(), system.size());
    for (const FieldBasis* basis : {&krylov.displacements(), &krylov.phi()}) {
      const Eigen::MatrixXd V = basis->columns();
      EXPECT_LT((V.transpose() * V - Eigen::MatrixXd::Identity(V.cols(), V.cols())).norm(), 1e-11);
    }
    EXPECT_FALSE(krylov.extend_together());
  }
}

TEST(Krylov, RefusesWhatItCannotReduce) {
  System system = loaded_sample({}, hat());
  EXPECT_THROW(SecondOrderKrylov(system, 0.), std::invalid_argument);
  EXPECT_THROW(SecondOrderKrylov(system, std::nan("")), std::invalid_argument);
  for (SystemLoad& load : system.loads) load.vector.setZero();
  EXPECT_THROW(SecondOrderKrylov(system, shift), NumericsError);
  EXPECT_THROW(SecondOrderKrylov(oscillator(0., 0., 0., hat()), shift), NumericsError);
}

}  // namespace krylov_test
