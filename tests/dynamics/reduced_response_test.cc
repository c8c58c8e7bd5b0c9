// Claims: a reduced model on an exhausted space has the response of a march: to forces, to prescribed velocities of u
// and of phi, with incompressible fluids with and without seepage, and for positions that only a dashpot holds.
// Source: SDIRK of order 4 with small steps; the closed form of a mass on a dashpot. Tolerances: the error of the
// march; 1e-5 with an incompressible fluid, whose phi is given damping of 1e-6.
#include <gtest/gtest.h>

#include <cmath>

#include "reduction_tools.h"

namespace reduced_response_test {

using namespace upbead;
using namespace upbead::test;

constexpr double shift = 2., end = 6.;
constexpr int n_steps = 4800;

double error_of(const System& system) {
  const Series march = marched(system, end, n_steps);
  return error(responded(modes_of(reduced(system, shift)), system, march.time), march.reading);
}

/// A system with a prescribed unknown and a reading of its position; without a reading of an acceleration, which
/// would need f'.
System prescribed(bool phi) {
  Sample sample;
  (phi ? sample.prescribed_phi : sample.prescribed_u) = true;
  System system = loaded_sample(sample, hat());
  system.readings.erase(system.readings.begin() + 2);
  system.readings.push_back({"given", "", "", {{system.size() - 1, 1.}}, {}, {}, {}});
  for (Reading& reading : system.readings) reading.feedthrough.clear();
  system.loads = {prescribed_load(system, hat())};
  return system;
}

TEST(ReducedResponse, IsThatOfAMarch) {
  for (const Sample& sample : {Sample{}, Sample{1., 0.}, Sample{1., 0., 0., 0.}})
    EXPECT_LT(error_of(loaded_sample(sample, hat())), 1e-8);
}

TEST(ReducedResponse, OfAnIncompressibleFluid) {
  for (const double darcy : {1., 0.}) {
    System system = loaded_sample({0., darcy}, hat());
    system.loads.pop_back();  // a source of fluid that an incompressible fluid cannot take up
    for (Reading& reading : system.readings)
      if (!reading.feedthrough.empty()) reading.feedthrough.resize(system.loads.size());
    // Without seepage, too, phi is not determined (see krylov_test.cc); displacements are.
    if (darcy == 0.) system.readings.pop_back();
    EXPECT_LT(error_of(system), 1e-5) << "darcy " << darcy;
  }
}

TEST(ReducedResponse, ToAPrescribedVelocity) {
  for (const bool phi : {false, true}) {
    const System system = prescribed(phi);
    EXPECT_LT(error_of(system), 1e-6) << (phi ? "phi" : "u");
  }
}

TEST(ReducedResponse, PositionOfWhatIsPrescribed) {
  for (const bool phi : {false, true}) {
    const System system = prescribed(phi);
    const std::vector<double> time{0., 0.5, 1., 1.5, 2., 50.};
    Eigen::RowVectorXd integral(6);
    integral << 0., 0.125, 0.5, 0.875, 1., 1.;
    const Eigen::RowVectorXd y = responded(modes_of(reduced(system, shift)), system, time).bottomRows(1);
    EXPECT_LT((y - integral).cwiseAbs().maxCoeff(), 1e-10) << (phi ? "phi" : "u");
  }
}

TEST(ReducedResponse, OfAMassOnADashpot) {
  const double m = 2., c = 0.5, rate = c / m;
  const auto constant = TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 1.; }});
  const System system = oscillator(m, c, 0., constant);
  const std::vector<double> time{0., 0.5, 3., 100.};
  const Eigen::MatrixXd x = responded(modes_of(reduced(system, shift)), system, time);
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double expected = time[i] / c + std::expm1(-rate * time[i]) / (c * rate);
    EXPECT_NEAR(x(0, static_cast<Eigen::Index>(i)), expected, 1e-12 * time.back() / c);
  }
}

}  // namespace reduced_response_test
