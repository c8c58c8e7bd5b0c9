// Claims: the state space has the transfer function of the reduced system; in its coordinates A + A^T <= 0, so that
// no pole has a positive real part and the energy |s|^2 / 2 never grows without load, undamped or damped, not even in
// 1e6 units of time; readings that would need f' are refused; free masses follow the loads.
// Tolerances: round-off of the matrices' norm; 1e-9 after 2^20 products of matrices.
#include "dynamics/state_space.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include "algebra/eigenpairs.h"
#include "reduction_tools.h"
#include "upbead/base/error.h"

namespace state_space_test {

using namespace upbead;
using namespace upbead::test;

constexpr double shift = 0.8;

Sample undamped() {
  return {1., 0., 0., 0.};
}

std::vector<System> systems() {
  std::vector<System> list;
  for (const Sample& sample : {Sample{}, undamped(), Sample{0., 1.}, Sample{0., 0.}})
    list.push_back(loaded_sample(sample, hat()));
  list.push_back(chain(30, 1., 0.5, 0.1));
  list.push_back(chain(30, 1., 0., 0.));
  return list;
}

Eigen::MatrixXcd transfer_of(const StateSpace& space, std::complex<double> s) {
  const auto N = space.A.rows();
  const Eigen::MatrixXcd X =
      (s * Eigen::MatrixXcd::Identity(N, N) - space.A).partialPivLu().solve(Eigen::MatrixXcd(space.B));
  return space.C * X + space.D + (space.E * X + space.F) / s;
}

TEST(StateSpace, HasTheTransferFunctionOfTheReducedSystem) {
  for (const bool phi : {false, true}) {
    Sample sample;
    (phi ? sample.prescribed_phi : sample.prescribed_u) = true;
    System system = loaded_sample(sample, hat());
    system.readings.erase(system.readings.begin() + 2);  // an acceleration
    system.loads.push_back(prescribed_load(system, hat()));
    const ReducedSystem r = reduced(system, shift, 6);
    for (const std::complex<double> s : {std::complex<double>(0.1, 1.), std::complex<double>(0.3, 5.)}) {
      EXPECT_LT(relative(transfer_of(state_space(r), s), transfer(r, s)), 1e-12);
      EXPECT_LT(relative(transfer(modes_of(r), s), transfer(r, s)), 1e-10);
    }
  }
}

TEST(StateSpace, LetsNoEnergyGrow) {
  for (const System& system : systems()) {
    const Eigen::MatrixXd A = state_space(reduced(system, shift)).A;
    const Eigen::MatrixXd symmetric = 0.5 * (A + A.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric, Eigen::EigenvaluesOnly);
    EXPECT_LE(eigen.eigenvalues().maxCoeff(), 1e-12 * A.norm());
    EXPECT_LE(eigenpairs(A).value.real().maxCoeff(), 1e-12 * A.norm());
    EXPECT_LE(modes_of(reduced(system, shift)).pole.real().maxCoeff(), 0.);
  }
}

TEST(StateSpace, EnergyFallsFromALoadedState) {
  for (const System& system : systems()) {
    const StateSpace space = state_space(reduced(system, shift));
    Eigen::MatrixXd P = (0.05 * space.A).exp();
    Eigen::VectorXd s = space.B.rowwise().sum();
    for (int i = 0; i < 200; ++i) {
      const double before = s.squaredNorm();
      s = P * s;
      EXPECT_LE(s.squaredNorm(), before * (1. + 1e-12));
    }
    for (int i = 0; i < 20; ++i) P = P * P;
    EXPECT_LE((P * s).norm(), s.norm() * (1. + 1e-9));
  }
}

TEST(StateSpace, KeepsTheEnergyOfWhatIsUndamped) {
  const StateSpace space = state_space(reduced(loaded_sample(undamped(), hat()), shift));
  const Eigen::VectorXd s = space.B.rowwise().sum();
  EXPECT_NEAR(((10. * space.A).exp() * s).norm(), s.norm(), 1e-12 * s.norm());
}

TEST(StateSpace, AMillionSecondsOfFreeDecay) {
  const std::vector<double> time{0., 1., 2., 1e2, 1e3, 1e4, 1e5, 1e6 - 1., 1e6};
  for (const System& system : systems()) {
    const ReducedSystem r = reduced(system, shift);
    const StateSpace space = state_space(r);
    const Eigen::MatrixXd y = responded(modes_of(r), system, time).rightCols(6);
    ASSERT_TRUE(y.allFinite());
    // The integral of the hat is 1, so that the norm of the state after it is at most that of B.
    const double start = space.B.rowwise().sum().norm();
    for (Eigen::Index i = 0; i < y.rows(); ++i) {
      if (!space.E.row(i).isZero(0.)) continue;  // an integral of the state, which the energy does not bound
      EXPECT_LE(y.row(i).cwiseAbs().maxCoeff(), space.C.row(i).norm() * start)
          << system.readings[static_cast<std::size_t>(i)].name.text();
    }
  }
}

TEST(StateSpace, RefusesTheAccelerationOfWhatIsPrescribed) {
  Sample sample;
  sample.prescribed_u = true;
  System system = sample_system(sample);
  system.loads = {prescribed_load(system, hat())};
  EXPECT_THROW(state_space(reduced(system, shift)), NumericsError) << "M couples a0 with the prescribed u";
  system.readings[2].acceleration = {{system.size() - 1, 1.}};
  EXPECT_THROW(state_space(reduced(system, shift)), NumericsError);
  system.readings.pop_back();
  EXPECT_NO_THROW(state_space(reduced(system, shift)));
}

TEST(StateSpace, MassesThatNothingHoldsAreFollowed) {
  const auto followed = [](const System& system) {
    const ModalModel model = modes_of(reduced(system, shift));
    const double s = 0.1 * shift;  // slow enough to show a pole that is not exactly zero
    const ReducedSystem r = reduced(system, shift);
    const Eigen::MatrixXd T = s * s * r.M + s * r.C + r.K;
    const Eigen::VectorXd q = T.partialPivLu().solve(r.load.col(0));
    double worst = 0.;
    for (int i = 0; i < model.n_readings(); ++i) {
      const double exact = (r.position.row(i) + s * r.velocity.row(i) + s * s * r.acceleration.row(i)) * q;
      worst = std::max(worst, std::abs(model.transfer(i, 0, s) / (exact + r.feedthrough(i, 0)) - 1.));
    }
    return worst;
  };
  EXPECT_LT(followed(oscillator(2., 0., 0., hat())), 1e-6);
  EXPECT_THROW(modes_of(reduced(oscillator(0., 2., 3., hat()), shift)), NumericsError) << "without mass";
  // Two masses on a spring: one pair of poles at zero beside one that swings.
  System pair = chain(2, 1., 0., 0.);
  pair.K.coeffRef(0, 0) = 1.;
  pair.C.setZero();
  EXPECT_LT(followed(pair), 1e-6);
}

}  // namespace state_space_test
