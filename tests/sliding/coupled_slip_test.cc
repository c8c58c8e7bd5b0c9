// Claim: a block that slips on a moving base follows event-exact references and closed forms: ref7 B and C
// (tests/reference/ref7_sliding.json), the exact block on rigid and on stiff ground, two masses under any history.

#include "sliding/coupled_slip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "lumped.h"
#include "upbead/base/error.h"
#include "upbead/sliding/pulse.h"

namespace upbead::test {
namespace coupled_slip_test {

using Json = nlohmann::json;

constexpr double friction = 0.6, shift = 30.;

Json reference(const char* part) {
  return Json::parse(std::ifstream(REFERENCE_FILE))[part];
}

/// A triangular pulse of 200 samples, and a second of rest.
CoupledSliding slide_pulse(const SlipModel& model, const TriangularPulse& pulse, double R) {
  const double step = pulse.duration / 200.;
  const int n = 201 + static_cast<int>(1. / step);
  return CoupledSlip(model, step).slide(samples(history(pulse), R / friction, step, n));
}

TEST(CoupledSlip, OnAMassWithSpringAndDashpotIsTheReference) {
  int slips = 0;
  for (const Json& row : reference("stickslip")) {
    SCOPED_TRACE(row["td"].dump() + " s, " + row["Pm"].dump() + " N/m");
    const SlipModel model = in_modes(block_on_base(row["m"], {row["mb"], row["kb"], row["cb"]}), friction, shift);
    const CoupledSliding found = slide_pulse(model, {row["Pm"], row["td"]}, row["R"]);
    const double residual = row["residual_relative_slip"], peak = row["max_FT"];
    EXPECT_NEAR(found.slip.residual, residual, 1e-8 * std::abs(residual) + 1e-15);
    EXPECT_NEAR(std::abs(found.peak_shear), peak, 1e-3 * peak) << "looked at at samples";
    EXPECT_EQ(found.n_passed_over, 0);
    const Json& events = row["events"];
    ASSERT_EQ(2 * found.slip.slips.size(), events.size());
    for (std::size_t i = 0; i < found.slip.slips.size(); ++i, ++slips) {
      EXPECT_NEAR(found.slip.slips[i].start, events[2 * i][0].get<double>(), 1e-9);
      EXPECT_NEAR(found.slip.slips[i].stop, events[2 * i + 1][0].get<double>(), 1e-9);
    }
  }
  EXPECT_GE(slips, 4);
}

// A base without mass has no state in a slip: it is the limit of a light base with a stiff dashpot, and the error is
// proportional to the root of its mass. So S is extrapolated from two masses.
TEST(CoupledSlip, OnABareSpringIsTheReference) {
  int slips = 0;
  for (const Json& row : reference("slider")) {
    SCOPED_TRACE(row["td"].dump() + " s, " + row["Pm"].dump() + " N/m");
    const auto residual = [&](double share) {
      const double mass = row["m"], k = row["k"], light = share * share * mass;
      const SlipModel model = in_modes(block_on_base(mass, {light, k, 4. * std::sqrt(light * k)}), friction, shift);
      return slide_pulse(model, {row["Pm"], row["td"]}, row["R"]).slip.residual;
    };
    const double exact = row["residual_slip"], light = residual(1e-6), lighter = residual(5e-7);
    EXPECT_NEAR(lighter, exact, 1e-5 * exact);
    EXPECT_NEAR(2. * lighter - light, exact, 1e-7 * exact);
    slips += exact > 0. ? 1 : 0;
  }
  EXPECT_GE(slips, 4);
}

TEST(CoupledSlip, OnRigidGroundIsTheExactBlock) {
  const double mass = 6e5, R = 1.94e6;
  const SlipModel model = in_modes(block_on_rock(mass), friction, shift);
  for (const double peak : {1.01, 1.3, 2., 4.}) {
    const TriangularPulse pulse{peak * R, 0.3};
    const double exact = sliding_distance_exact(mass, R, pulse);
    EXPECT_NEAR(slide_pulse(model, pulse, R).slip.residual, exact, 1e-11 * exact);
  }
}

TEST(CoupledSlip, OnStiffGroundTendsToTheExactBlock) {
  const double mass = 6e5, R = 1.94e6;
  const TriangularPulse pulse{2. * R, 0.3};
  const double exact = sliding_distance_exact(mass, R, pulse);
  const auto error = [&](double stiffness) {
    const double base = 1e-3 * mass;
    const ElasticBase ground{base, stiffness, 4. * std::sqrt(base * stiffness)};
    return std::abs(
        slide_pulse(in_modes(block_on_base(mass, ground), friction, shift), pulse, R).slip.residual / exact - 1.);
  };
  EXPECT_LT(error(1e15), 1e-6);
  EXPECT_GT(error(1e11), 1e-6);
}

/// Points at random times, all of which are times of samples.
History random_history(unsigned seed, double largest) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> gap(5, 100);
  std::uniform_real_distribution<double> value(-largest, largest);
  History force{{0.}, {0.}};
  for (int n = 0, i = 1; i < 12; ++i) {
    n += gap(random);
    force.time.push_back(n * 1e-3);
    force.value.push_back(i < 11 ? value(random) : 0.);
  }
  return force;
}

TEST(CoupledSlip, IsThatOfTwoMassesUnderAnyHistory) {
  const double mass = 6e5, R = 1.94e6;
  const ElasticBase base{2e5, 6e8, 4e6};
  const CoupledSlip slip(in_modes(block_on_base(mass, base), friction, shift), 1e-3);
  std::size_t slips = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const History force = random_history(seed, 4. * R);
    const CoupledSliding found = slip.slide(samples(force, R / friction, 1e-3, 2000));
    const ElasticSliding expected = slide_on_base(mass, base, force, R);
    ASSERT_EQ(found.slip.slips.size(), expected.slip.slips.size()) << "seed " << seed;
    EXPECT_NEAR(found.slip.residual, expected.slip.residual, 1e-9 * expected.slip.path) << "seed " << seed;
    EXPECT_NEAR(found.slip.path, expected.slip.path, 1e-9 * expected.slip.path) << "seed " << seed;
    slips += found.slip.slips.size();
  }
  EXPECT_GT(slips, 100u);
}

TEST(CoupledSlip, OwnTimesAndJumpsCount) {
  // 2R for a time T: S = R T^2 / m, over at 2T.
  const double mass = 6e5, R = 1.94e6, T = 0.3;
  const CoupledSlip slip(in_modes(block_on_rock(mass), friction, shift), 0.01);
  SampledLoads loads{{0., 0.1, 0.1 + T, 1., 1.25}, Eigen::MatrixXd(2, 4), {}};
  loads.begin << 0., 2. * R, 0., 0., R / friction, R / friction, R / friction, R / friction;
  loads.end = loads.begin;
  CoupledHistory history;
  const CoupledSliding found = slip.slide(loads, &history);
  ASSERT_EQ(found.slip.slips.size(), 1u);
  EXPECT_NEAR(found.slip.residual, R * T * T / mass, 1e-12);
  EXPECT_NEAR(found.slip.slips[0].start, 0.1, 1e-12);
  EXPECT_NEAR(found.slip.slips[0].stop, 0.1 + 2. * T, 1e-12);
  EXPECT_NEAR(found.slip.slips[0].peak_velocity, R * T / mass, 1e-12);
  EXPECT_NEAR(found.dissipated, R * found.slip.residual, 1e-6);
  EXPECT_NEAR(history.slip[2], 0.5 * R * T * T / mass, 1e-12);
  EXPECT_NEAR(history.velocity[2], R * T / mass, 1e-12);
  EXPECT_NEAR(history.shear[2], R, 1e-6);
  EXPECT_EQ(history.shear[4], 0.);
}

TEST(CoupledSlip, TurnsWithoutARestAndCountsTwoSlips) {
  // 4R for a time T, then -10R: v = 3R T/m, which 11R/m stop; from there 9R/m push seaward until T + 2T
  const double mass = 6e5, R = 1.94e6, T = 0.1, turn = T + 3. * T / 11.;
  const CoupledSlip slip(in_modes(block_on_rock(mass), friction, shift), 0.01);
  SampledLoads loads{{0., T, 3. * T, 2.}, Eigen::MatrixXd(2, 3), {}};
  loads.begin << 4. * R, -10. * R, 0., R / friction, R / friction, R / friction;
  loads.end = loads.begin;
  const CoupledSliding found = slip.slide(loads);
  ASSERT_EQ(found.slip.slips.size(), 2u);
  EXPECT_NEAR(found.slip.slips[0].stop, turn, 1e-12);
  EXPECT_NEAR(found.slip.slips[1].start, turn, 1e-12);
  const double v = 3. * R * T / mass, w = 9. * R * (3. * T - turn) / mass;
  EXPECT_NEAR(found.slip.slips[0].distance, 0.5 * v * turn, 1e-12);
  EXPECT_NEAR(found.slip.slips[1].distance, -0.5 * w * (3. * T - turn) - 0.5 * w * w * mass / R, 1e-10);
}

TEST(CoupledSlip, FollowsASlipBeyondTheLastSample) {
  const double mass = 6e5, R = 1.94e6;
  const CoupledSlip slip(in_modes(block_on_rock(mass), friction, shift), 0.01);
  WaveSamples loads(2, 31);
  loads.row(0).setConstant(2. * R);
  loads.row(1).setConstant(R / friction);
  EXPECT_THROW(slip.slide(loads), NumericsError) << "it never stops";
  loads(0, 30) = 0.;
  const CoupledSliding found = slip.slide(loads);
  EXPECT_GT(found.slip.slips[0].stop, 0.5);
  EXPECT_THROW(slip.slide(loads.topRows(1)), std::invalid_argument);
}

}  // namespace coupled_slip_test
}  // namespace upbead::test
