// Claims: a projected system has the structure of the whole system: symmetric, and with the rows of phi multiplied by
// -1 M >= 0, sym(C) >= 0, K >= 0; on an exhausted space it has the same response; projecting step by step equals
// projecting at once; a coupling of phi with displacements in M or K is refused.
// Tolerances: 1e-13 and 1e-12 of the largest entry or eigenvalue are round-off of sums over a dozen unknowns.
#include "dynamics/projection.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "reduction_tools.h"

namespace projection_test {

using namespace upbead;
using namespace upbead::test;

constexpr double shift = 0.8;

System loaded(const Sample& sample) {
  System system = loaded_sample(sample, hat());
  for (int i = 0; i < system.n_prescribed; ++i) {
    system.loads.push_back(prescribed_load(system, hat()));
    system.loads.back().prescribed -= i;
  }
  return system;
}

std::vector<System> systems() {
  std::vector<System> list;
  for (const double storage : {1., 0.})
    for (const double darcy : {1., 0.})
      for (const bool u : {false, true})
        for (const bool phi : {false, true}) list.push_back(loaded({storage, darcy, 1., 0.1, u, phi}));
  list.push_back(chain(40, 0., 0.5, 0.));
  return list;
}

void expect_symmetric(const Eigen::MatrixXd& A) {
  EXPECT_LE((A - A.transpose()).cwiseAbs().maxCoeff(), 1e-13 * A.cwiseAbs().maxCoeff());
}

/// Expects A with the rows of phi multiplied by -1 to have a symmetric part without negative eigenvalues.
void expect_positive(const ReducedSystem& r, const Eigen::MatrixXd& A, const char* name) {
  Eigen::MatrixXd flipped = A;
  for (int i = 0; i < r.size(); ++i)
    if (r.is_phi[static_cast<std::size_t>(i)]) flipped.row(i) *= -1.;
  const Eigen::MatrixXd symmetric = 0.5 * (flipped + flipped.transpose());
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  EXPECT_GT(values.maxCoeff(), 0.) << name;
  EXPECT_GE(values.minCoeff(), -1e-12 * values.maxCoeff()) << name;
}

TEST(Projection, KeepsSymmetryAndSigns) {
  for (const System& system : systems())
    for (const int vectors : {5, 8, 1000}) {
      const ReducedSystem r = reduced(system, shift, vectors);
      for (const Eigen::MatrixXd* A : {&r.M, &r.C, &r.K}) expect_symmetric(*A);
      expect_positive(r, r.M, "M");
      expect_positive(r, r.C, "C");
      expect_positive(r, r.K, "K");
    }
}

TEST(Projection, OnAnExhaustedSpaceAnswersAsTheSystem) {
  for (const System& system : systems()) {
    if (system.size() > 20) continue;
    const bool has_phi = system.M.coeff(10, 10) + system.C.coeff(10, 10) != 0.;
    const ReducedSystem all = whole(system, shift), same = reduced(system, shift);
    for (const std::complex<double> s : {std::complex<double>(0.1, 1.), std::complex<double>(0.3, 5.)}) {
      const Eigen::MatrixXcd expected = transfer(all, s), found = transfer(same, s);
      // The last reading is one of phi, which without storage and seepage is not determined, see krylov_test.cc.
      const Eigen::Index rows = expected.rows() - (has_phi ? 0 : 1);
      EXPECT_LT(relative(found.topRows(rows), expected.topRows(rows)), 1e-11);
    }
  }
}

TEST(Projection, GrowsToWhatItIsAtOnce) {
  const System system = chain(40, 1., 0.5, 0.1);
  SecondOrderKrylov krylov(system, shift, {7, 50});
  Projection grown(system, krylov);
  for (int n = 0; n < 20; ++n) {
    ASSERT_TRUE(krylov.extend());
    if (n % 3 == 0) grown.extend();
  }
  grown.extend();
  const ReducedSystem a = grown.reduced(), b = Projection(system, krylov).reduced();
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.is_phi, b.is_phi);
  for (const auto part : {&ReducedSystem::M, &ReducedSystem::C, &ReducedSystem::K, &ReducedSystem::load,
                          &ReducedSystem::position, &ReducedSystem::velocity})
    EXPECT_LT((a.*part - b.*part).norm(), 1e-14 * (b.*part).norm());
}

TEST(Projection, RefusesStiffnessBetweenPhiAndDisplacements) {
  System system = chain(5, 1., 0.5, 0.1);
  system.K.coeffRef(0, 7) = system.K.coeffRef(7, 0) = 0.1;
  const SecondOrderKrylov krylov(system, shift);
  EXPECT_THROW(Projection(system, krylov), std::logic_error);
}

}  // namespace projection_test
