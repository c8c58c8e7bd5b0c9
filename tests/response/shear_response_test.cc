// Claims: F_T per impulse is told of forces both ways, and not of a force without impulse; an imbalance of energy is
// told with the error that it means, which is small where the loads could do far more work than they do.
#include "response/shear_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace shear_response_test {

constexpr double duration = 0.15, end = 0.3, peak = 1.6e6;

ShearResponse answer(const Mesh& mesh, const TimeFunction& force) {
  Scene scene = breakwater(force);
  scene.time.end = end;
  const Compiled compiled(scene, mesh);
  return shear_of(compiled, run(compiled, end, duration / 20.));
}

TEST(ShearResponse, IsToldPerImpulseOfForcesBothWays) {
  const auto mesh = breakwater_mesh(0.5);
  const ShearResponse landward = answer(*mesh, triangle(peak, duration));
  ASSERT_TRUE(landward.shear_to_impulse);
  EXPECT_NEAR(landward.impulse, 0.5 * peak * duration, 1e-9 * peak);
  EXPECT_NEAR(*landward.shear_to_impulse, landward.peak_shear / landward.impulse, 1e-12 * *landward.shear_to_impulse);
  const ShearResponse seaward = answer(*mesh, triangle(-0.5 * peak, duration));
  ASSERT_TRUE(seaward.shear_to_impulse);
  EXPECT_LT(seaward.impulse, 0.);
  EXPECT_NEAR(*seaward.shear_to_impulse, *landward.shear_to_impulse, 1e-9 * *landward.shear_to_impulse);
  const TimeFunction both_ways =
      piecewise_linear({0., 0.25 * duration, 0.5 * duration, 0.75 * duration, duration}, {0., peak, 0., -peak, 0.});
  EXPECT_FALSE(answer(*mesh, both_ways).shear_to_impulse);
  const TimeFunction rather_seaward =
      piecewise_linear({0., 0.125 * duration, 0.25 * duration, duration}, {0., -2. * peak, 0., 0.});
  const TimeFunction back =
      piecewise_linear({0., 0.25 * duration, 0.5 * duration, 0.75 * duration, duration}, {0., 0., peak, 0., 0.});
  EXPECT_FALSE(answer(*mesh, sum(rather_seaward, back)).shear_to_impulse) << "the largest force is a seaward one";
}

TEST(ShearResponse, HasNoRatioWithoutAForce) {
  const auto mesh = breakwater_mesh(0.35);
  const ShearResponse still = answer(*mesh, triangle(0., duration));
  EXPECT_FALSE(still.shear_to_force_ratio);
  EXPECT_FALSE(still.shear_to_impulse);
}

/// 1/2 (peak b_i)^2 / K_ii over the displacements of a column that a pressure loads at its top.
double possible_work(const System& system, double pressure) {
  double work = 0.;
  for (int i = 0; i < system.n_free(); ++i) {
    const double force = pressure * system.loads.at(0).vector[i], stiffness = system.K.coeff(i, i);
    if (system.field[i] == Field::displacement && stiffness > 0.) work += 0.5 * force * force / stiffness;
  }
  return work;
}

/// In a column under a pressure a thousandth of what the load could do is done, of which a share is lost.
Mismatch told(double pressure, double share) {
  Region soil = sand();
  soil.flow = Flow::drained;
  const auto mesh = column_mesh(10., 5);
  const Compiled compiled(column(soil, piecewise_linear({0., 0.1, 0.2}, {0., pressure, 0.})), *mesh);
  const System& system = compiled.system;
  EnergyAccount energy;
  energy.work = energy.largest_work = 1e-3 * possible_work(system, pressure);
  energy.strain = (1. - share) * energy.work;
  try {
    require_balance(energy, system, 0.2);
  } catch (const Imbalance& imbalance) {
    return imbalance.mismatch();
  }
  return {};
}

TEST(Balance, OfEnergyTellsTheErrorThatItMeans) {
  for (const double pressure : {3e4, 3.}) {  // of which the second does less than 1 J/m
    EXPECT_EQ(told(pressure, 1e-7).value, 0.) << "tolerable";
    const Mismatch small = told(pressure, 1e-5), large = told(pressure, 1e-2);
    EXPECT_NEAR(small.value, 1e-5, 1e-11);
    EXPECT_NEAR(small.error, std::sqrt(1e-8), 1e-9);
    EXPECT_TRUE(small.bearable);
    EXPECT_NEAR(large.error, std::sqrt(1e-5), 1e-8);
    EXPECT_FALSE(large.bearable);
  }
}

}  // namespace shear_response_test
}  // namespace upbead::test
