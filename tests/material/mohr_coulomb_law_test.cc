#include "material/mohr_coulomb_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "law_paths.h"
#include "upbead/base/error.h"

namespace upbead {
namespace mohr_coulomb_law_test {

using namespace testing;

constexpr double G = 60e6, nu = 0.3, pi = 3.14159265358979323846;
const ElasticLaw elastic = elastic_law(G, nu);

SoilPath path_of(const MohrCoulombLaw& law, const PlaneStress& rest) {
  const PlaneStress borne = law.excess(rest) > 0. ? law.returned(rest) : rest;
  return {mohr_coulomb_points(std::make_shared<const MohrCoulombLaw>(law), {rest})(0), law.elastic(), borne};
}

/// Column j of the tangent by a one-sided difference: d sigma / d eps_xx, eps_yy or gamma.
std::array<double, 3> column(const MohrCoulombLaw& law, const PlaneStrain& strain, const MohrCoulombLaw::State& state,
                             int j, double step) {
  PlaneStrain moved = strain;
  (j == 0 ? moved.xx : j == 1 ? moved.yy : moved.xy) += j == 2 ? 0.5 * step : step;
  MohrCoulombLaw::State one = state, two = state;
  const PlaneStress a = law.update(strain, one).stress, b = law.update(moved, two).stress;
  return {(b.xx - a.xx) / step, (b.yy - a.yy) / step, (b.xy - a.xy) / step};
}

double sine(double degrees) {
  return std::sin(pi * degrees / 180.);
}

/// Shear at a constant volume: the mean stress in the plane is constant, tau ends at c cos phi + p sin phi.
TEST(MohrCoulombLaw, ShearEndsAtTheStrengthOfThePlane) {
  for (const double phi : {0., 20., 35., 45.}) {
    const double cohesion = 15e3, p = 120e3;
    const MohrCoulombLaw law(elastic, {phi, cohesion, 0., 0.});
    MohrCoulombLaw::State state{{-p, -p, 0., -p}, {}};
    for (int i = 1; i <= 20; ++i) law.update({0., 0., 1e-3 * i}, state);
    const double cosine = std::sqrt(1. - sine(phi) * sine(phi));
    EXPECT_NEAR(state.stress.xy, cohesion * cosine + p * sine(phi), 1e-9 * p) << phi;
    EXPECT_NEAR(0.5 * (state.stress.xx + state.stress.yy), -p, 1e-9 * p);
  }
}

/// The rate of plastic volume (expansion positive) over that of plastic shear is sin psi in the plane; with the stress
/// at its limit, all strain is plastic.
TEST(MohrCoulombLaw, FlowWidensByTheDilatancyAngle) {
  const double psi = 12., p = 100e3;
  const MohrCoulombLaw law(elastic, {35., 5e3, psi, 0.});
  MohrCoulombLaw::State state{{-p, -p, 0., -p}, {}};
  const double widening = sine(psi);  // eps_v = sin psi gamma_max: the direction of plastic flow
  PlaneStress before;
  for (int i = 1; i <= 40; ++i) {
    before = state.stress;
    law.update({0.5 * widening * 2e-3 * i, 0.5 * widening * 2e-3 * i, 1e-3 * i}, state);
  }
  EXPECT_NEAR(state.stress.xx, before.xx, 1e-9 * p);
  EXPECT_NEAR(state.stress.xy, before.xy, 1e-9 * p);
  EXPECT_NEAR(law.excess(state.stress), 0., 1e-9 * p);
}

/// One strain for each kind of edge and corner, by the number of equal principal stresses and of those at the limit
/// of tension.
TEST(MohrCoulombLaw, ReturnsToPlanesEdgesAndCorners) {
  const double tension = 4e3;
  const MohrCoulombLaw law(elastic, {30., 10e3, 10., tension});
  const auto returned = [&](double xx, double yy, double zz) {
    MohrCoulombLaw::State state{{xx, yy, 0., zz}, {}};
    return law.update({}, state).stress;
  };
  const double small = 1e-6, k = 3.;
  const double strength = 2. * 10e3 * std::sqrt(k);
  PlaneStress s = returned(-50e3, -500e3, -200e3);  // plane
  EXPECT_NEAR(k * s.xx - s.yy, strength, small);
  EXPECT_LT(s.yy, s.zz - 1e3);
  EXPECT_LT(s.zz, s.xx - 1e3);
  s = returned(-50e3, -500e3, -50e3);  // edge of compression: two largest equal
  EXPECT_NEAR(s.xx, s.zz, small);
  EXPECT_NEAR(k * s.xx - s.yy, strength, small);
  s = returned(-50e3, -500e3, -500e3);  // edge of extension: two smallest equal
  EXPECT_NEAR(s.yy, s.zz, small);
  EXPECT_NEAR(k * s.xx - s.yy, strength, small);
  s = returned(20e3, 0., -5e3);  // plane of tension
  EXPECT_NEAR(s.xx, tension, small);
  EXPECT_LT(s.yy, tension - 100.);
  s = returned(20e3, 19e3, -20e3);  // edge of tension
  EXPECT_NEAR(s.xx, tension, small);
  EXPECT_NEAR(s.yy, tension, small);
  EXPECT_LT(s.zz, tension - 100.);
  s = returned(300e3, 310e3, 305e3);  // corner
  for (const double value : {s.xx, s.yy, s.zz}) EXPECT_NEAR(value, tension, small);
  s = returned(130e3, -50e3, 20e3);  // where shear and tension meet
  EXPECT_NEAR(s.xx, tension, small);
  EXPECT_NEAR(k * s.xx - s.yy, strength, small);
}

/// Without a cut-off of its own, sand cannot be pulled: tension ends at the apex c' / tan phi', 0 for sand.
TEST(MohrCoulombLaw, TensionEndsAtTheApex) {
  const MohrCoulombLaw clay(elastic, {25., 10e3, 0., 1e9}), sand(elastic, {35., 0., 0., 1e9});
  const double pull = 1e-2;
  MohrCoulombLaw::State one, two;
  EXPECT_NEAR(clay.update({pull, pull, 0.}, one).stress.zz, 10e3 / std::tan(25. * pi / 180.), 1e-3);
  EXPECT_NEAR(sand.update({pull, pull, 0.}, two).stress.xx, 0., 1e-3);
}

TEST(MohrCoulombLaw, MillionRandomStepsStayWithinAndTakeEnergy) {
  std::mt19937 random(11);
  double outside = 0., least = 0.;
  for (int run = 0; run < 1000; ++run) {
    const double phi = 5. * (run % 9), psi = phi * (run % 4) / 3., cohesion = run % 3 == 0 ? 0. : 20e3;
    const MohrCoulombLaw law(elastic, {phi, cohesion + (phi == 0. ? 5e3 : 0.), psi, run % 5 == 0 ? 3e3 : 0.});
    SoilPath path = path_of(law, {-50e3, -80e3, 0., -60e3});
    PlaneStrain strain;
    for (int i = 0; i < 1000; ++i) {
      strain = plus(strain, random_strain(random, 3e-4));
      const SoilPath::Answer answer = path.to(strain);
      const double size = std::abs(answer.stress.xx) + std::abs(answer.stress.yy) + std::abs(answer.stress.zz) + 1e4;
      outside = std::max(outside, law.excess(answer.stress) / size);
      least = std::min(least, answer.dissipated / (size * 3e-4));
    }
  }
  EXPECT_LT(outside, 1e-8);
  EXPECT_GT(least, -1e-9);
}

TEST(MohrCoulombLaw, TangentIsThatOfDifferences) {
  std::mt19937 random(5);
  int compared = 0, all = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool associated = i % 2 == 0;
    const MohrCoulombLaw law(elastic, {30., 10e3, associated ? 30. : 5., i % 3 == 0 ? 2e3 : 0.});
    const MohrCoulombLaw::State state{{-40e3, -60e3, 5e3, -50e3}, {}};
    const PlaneStrain strain = random_strain(random, 1e-3);
    MohrCoulombLaw::State after = state;
    const Tangent T = law.update(strain, after).tangent;
    for (int j = 0; j < 3; ++j) {
      const auto up = column(law, strain, state, j, 1e-8), down = column(law, strain, state, j, -1e-8);
      for (int k = 0; k < 3; ++k) {
        if (associated) {
          EXPECT_NEAR(T[j][k], T[k][j], 1e-9 * G);
        }
        ++all;
        if (std::abs(up[k] - down[k]) > 1e-3 * G) continue;  // the two differences are on different planes
        ++compared;
        EXPECT_NEAR(T[k][j], 0.5 * (up[k] + down[k]), 1e-3 * G) << i;
      }
    }
  }
  EXPECT_GT(compared, 0.99 * all);
}

TEST(MohrCoulombLaw, AnswersInTurnedAxesAndInOtherUnits) {
  const MohrCoulombLaw law(elastic, {32., 8e3, 4., 1e3}), in_kPa(elastic_law(1e-3 * G, nu), {32., 8., 4., 1.});
  std::mt19937 random(3);
  const PlaneStress rest{-40e3, -60e3, 5e3, -50e3};
  SoilPath path = path_of(law, rest), turned = path_of(law, in_turned_axes(rest, 0.4)),
           other = path_of(in_kPa, {-40., -60., 5., -50.});
  for (int i = 0; i < 200; ++i) {
    const PlaneStrain strain = random_strain(random, 3e-4);
    const SoilPath::Answer answer = path.to(strain), kPa = other.to(strain);
    const PlaneStress back = in_turned_axes(turned.to(in_turned_axes(strain, 0.4)).stress, -0.4);
    const double small = 1e-8 * (1e4 + std::abs(answer.stress.xx) + std::abs(answer.stress.yy));
    EXPECT_NEAR(back.xx, answer.stress.xx, small);
    EXPECT_NEAR(back.xy, answer.stress.xy, small);
    EXPECT_NEAR(1e3 * kPa.stress.yy, answer.stress.yy, small);
    EXPECT_NEAR(1e3 * kPa.dissipated, answer.dissipated, small * 1e-3);
  }
}

TEST(MohrCoulombLaw, MobilisedShareOfStrength) {
  const MohrCoulombLaw law(elastic, {30., 10e3, 0., 2e3});
  const double strength = 10e3 * std::cos(pi / 6.) + 100e3 * 0.5;  // at a middle of 100 kPa
  EXPECT_NEAR(law.mobilised({-100e3, -100e3, 0.25 * strength, -100e3}), 0.25, 1e-12);
  EXPECT_NEAR(law.mobilised({-100e3 + 0.5 * strength, -100e3 - 0.5 * strength, 0., -100e3}), 0.5, 1e-12);
  EXPECT_EQ(law.mobilised({2e3, -5e3, 0., -1e3}), 1.) << "at the limit of tension";
  MohrCoulombLaw::State state{{-100e3, -100e3, 0., -100e3}, {}};
  EXPECT_NEAR(law.mobilised(law.update({0., 0., 0.01}, state).stress), 1., 1e-9);
}

TEST(MohrCoulombLaw, RefusesAllMistakesAtOnce) {
  try {
    MohrCoulombLaw(elastic, {95., -1., 100., -2.});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().list().size(), 4u);
  }
}

}  // namespace mohr_coulomb_law_test
}  // namespace upbead
