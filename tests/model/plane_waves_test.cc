// Claims: lambda^2 solves the equations of docs/theory.md, written out anew as a 3 x 3 system; without drag the speeds
// are those of the two matrices M and A, with much drag the fast wave is undrained and the slow one diffuses with c_v;
// darcy flow and drained soil are limits.
#include "model/plane_waves.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace upbead {
namespace plane_waves_test {

using Complex = std::complex<double>;

Material rubble(double conductivity) {
  Region region;
  region.shear_modulus = 50e6;
  region.poissons_ratio = 0.3;
  region.porosity = 0.4;
  region.grain_density = 2650.;
  region.hydraulic_conductivity = conductivity;
  region.damping = Rayleigh{0.03, {1., 10.}};
  return material(region, Fluid(), 9.81);
}

/// Momentum, fluid and mass for (u, W, p) ~ exp(s t - l x), each row over its largest entry.
double determinant(const Material& m, Complex s, Complex square) {
  const Complex l = std::sqrt(square), E = (m.lambda + 2. * m.G) * (1. + s * m.stiffness_damping);
  Eigen::Matrix3cd A;
  A << m.rho * (s * s + s * m.mass_damping) - E * square, m.rho_f * s * s, -m.alpha * l,  //
      m.rho_f * s * s, m.a * s * s + m.b * s, -l,                                         //
      -m.alpha * l, -l, m.storage;
  for (int i = 0; i < 3; ++i) A.row(i) /= A.row(i).cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) A.col(i) /= A.col(i).cwiseAbs().maxCoeff();
  return std::abs(A.determinant());
}

TEST(PlaneWaves, SolveBiotsEquations) {
  for (const double k : {1e-4, 0.1, 10.})
    for (const Complex s : {Complex(0., 3.), Complex(2., 60.), Complex(5., 900.)}) {
      const Material m = rubble(k);
      const PlaneWaves waves = plane_waves(m, Flow::inertial, s);
      EXPECT_LT(determinant(m, s, waves.fast), 1e-6);
      EXPECT_LT(determinant(m, s, waves.slow), 1e-6);
      EXPECT_GT(determinant(m, s, 1.1 * waves.fast), 1e-4);
    }
}

TEST(PlaneWaves, WithoutDragHaveTheSpeedsOfTheMatrices) {
  Material m = rubble(1e9);
  m.mass_damping = m.stiffness_damping = 0.;
  const double E = m.lambda + 2. * m.G, Q = 1. / m.storage;
  Eigen::Matrix2d M, A;
  M << m.rho, m.rho_f, m.rho_f, m.a;
  A << E + Q, Q, Q, Q;
  const Eigen::Vector2d squares = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(A, M).eigenvalues();
  const double omega = 50.;
  const PlaneWaves waves = plane_waves(m, Flow::inertial, Complex(0., omega));
  EXPECT_NEAR(-omega * omega / waves.slow.real() / squares[0], 1., 1e-6);
  EXPECT_NEAR(-omega * omega / waves.fast.real() / squares[1], 1., 1e-6);
  EXPECT_NEAR(-omega * omega / waves.shear.real() / (m.G / (m.rho - m.rho_f * m.rho_f / m.a)), 1., 1e-6);
}

TEST(PlaneWaves, WithMuchDragAreTheUndrainedWaveAndDiffusion) {
  Material m = rubble(1e-7);
  m.mass_damping = m.stiffness_damping = 0.;
  const Complex s(0., 50.);
  const double E = m.lambda + 2. * m.G, c_v = 1. / m.b / (1. / E + m.storage);
  for (const Flow flow : {Flow::inertial, Flow::darcy}) {
    const PlaneWaves waves = plane_waves(m, flow, s);
    EXPECT_NEAR(std::abs(waves.fast / (s * s * m.rho / (E + 1. / m.storage)) - 1.), 0., 1e-3);
    EXPECT_NEAR(std::abs(waves.slow / (s / c_v) - 1.), 0., 1e-3);
  }
  const PlaneWaves dry = plane_waves(m, Flow::drained, s);
  EXPECT_NEAR(std::abs(dry.fast / (s * s * m.rho / E) - 1.), 0., 1e-12);
  EXPECT_EQ(dry.slow, Complex(0.));
}

}  // namespace plane_waves_test
}  // namespace upbead
