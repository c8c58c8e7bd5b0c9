// Claim: waves slide a caisson coupled with its ground as two masses slide on each other, whatever the times of the
// waves; the uplift that the case prescribes is subtracted from W', and a model without a slip gives no coupled
// sliding distance.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../output/sample_model.h"
#include "respond/respond_slip.h"
#include "respond/respond_waves.h"
#include "response/slip_law.h"
#include "sliding/coupled_slip.h"
#include "sliding/elastic_block.h"

namespace upbead::test {

namespace respond_slip_test {

const double friction = 0.6, weight = 1.1e6;  // W' in N/m

ReducedModelFile model_with_slip() {
  ReducedModelFile model = oscillator();
  model.slip = slipping_oscillator();
  return model;
}

/// The same two masses, solved event by event.
ElasticSliding by_masses(const History& P) {
  const ReducedSystem system = slipping_oscillator().system;
  return slide_on_base(oscillator().caisson_mass, {system.M(1, 1), system.K(1, 1), system.C(1, 1)}, P,
                       friction * weight);
}

WaveFile wave(const History& P) {
  WaveFile file{"w", P.time, WaveSamples::Zero(2, static_cast<Eigen::Index>(P.time.size())), 2, {}};
  for (std::size_t n = 0; n < P.time.size(); ++n) file.value(0, static_cast<Eigen::Index>(n)) = P.value[n];
  return file;
}

/// A triangle of 0.15 s, given by its corners.
History triangle(double peak) {
  return {{0., 0.075, 0.15}, {0., peak, 0.}};
}

/// The same triangle on equal steps.
History fine_triangle(double peak) {
  History P;
  for (int n = 0; n <= 300; ++n) {
    P.time.push_back(n * 5e-4);
    P.value.push_back(peak * (1. - std::abs(n / 150. - 1.)));
  }
  return P;
}

CoupledWave slid(const WaveFile& file, const ModelSliding& sliding = {friction, weight}) {
  RespondOptions options;
  options.sliding = sliding;
  return *respond_to_waves(model_with_slip(), {file}, options)[0].waves[0].coupled;
}

void expect_equal(const CoupledWave& found, const ElasticSliding& expected, double tolerance) {
  ASSERT_GT(expected.slip.path, 1e-3);
  EXPECT_NEAR(found.sliding, expected.slip.residual, tolerance * expected.slip.path);
  EXPECT_NEAR(found.largest, expected.slip.largest, tolerance * expected.slip.path);
  EXPECT_EQ(found.slips, static_cast<int>(expected.slip.slips.size()));
  EXPECT_NEAR(found.dissipated, friction * weight * expected.slip.path, tolerance * found.dissipated);
}

TEST(RespondSlip, IsThatOfTwoMasses) {
  for (const double peak : {2e6, 3e6, -3e6}) {
    const ElasticSliding expected = by_masses(triangle(peak));
    expect_equal(slid(wave(fine_triangle(peak))), expected, 1e-8);
    expect_equal(slid(wave(triangle(peak))), expected, 1e-8);
  }
}

TEST(RespondSlip, JumpsCount) {
  const History inside{{0.1, 0.25, 0.9}, {3e6, 1.5e6, 3e5}};
  const History jumping{{0., 0.1, 0.1, 0.25, 0.9, 0.9}, {0., 0., 3e6, 1.5e6, 3e5, 0.}};
  expect_equal(slid(wave(inside)), by_masses(jumping), 1e-8);
}

TEST(RespondSlip, IsFollowedToItsStopWithoutLoadsAfterTheAnswer) {
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight};
  options.end = 0.1;
  const History whole = triangle(3e6), cut{{0., 0.075, 0.1, 0.1}, {0., 3e6, 2e6, 0.}};
  const WaveResponse by_corners = respond_to_waves(model_with_slip(), {wave(whole)}, options)[0].waves[0];
  expect_equal(*by_corners.coupled, by_masses(cut), 1e-8);
  const History falling{{0., 0.075, 0.1, 0.1005}, {0., 3e6, 2e6, 0.}};
  const WaveResponse by_steps = respond_to_waves(model_with_slip(), {wave(fine_triangle(3e6))}, options)[0].waves[0];
  expect_equal(*by_steps.coupled, by_masses(falling), 1e-8);
}

/// With N_0 = W' - U, where U is computed by hand from P.
CoupledSliding by_hand(const WaveFile& file, const std::function<double(int)>& uplift) {
  const ReducedSystem system = slipping_oscillator().system;
  const int n = 8001;  // 4 s, the end of the case
  WaveSamples loads = WaveSamples::Zero(3, n);
  loads.topLeftCorner(2, file.value.cols()) = file.value;
  for (int i = 0; i < n; ++i) loads(2, i) = weight - uplift(i);
  return CoupledSlip(slip_model(system, slip_law(system, friction, UpliftKind::prescribed)), 5e-4).slide(loads);
}

TEST(RespondSlip, PrescribedUpliftIsTakenOffTheWeight) {
  const WaveFile file = wave(fine_triangle(2e6));
  const auto P = [&file](int i) { return i >= 0 && i < file.value.cols() ? file.value(0, i) : 0.; };
  const auto expect = [&](const ModelSliding& sliding, const std::function<double(int)>& uplift) {
    const CoupledWave found = slid(file, sliding);
    const CoupledSliding expected = by_hand(file, uplift);
    EXPECT_NEAR(found.sliding, expected.slip.residual, 1e-9 * expected.slip.path) << sliding.uplift;
    EXPECT_NEAR(found.dissipated, expected.dissipated, 1e-9 * expected.dissipated) << sliding.uplift;
    EXPECT_NEAR(found.lifted_time, expected.lifted_time, 1e-9) << sliding.uplift;
    return found;
  };
  const double none = expect({friction, weight}, [](int) { return 0.; }).sliding;
  const CoupledWave in_phase = expect({friction, weight, 0., "in_phase", 0.6, 0.}, [&](int i) { return 0.6 * P(i); });
  EXPECT_GT(std::abs(in_phase.sliding - none), 0.01 * none);
  EXPECT_GT(in_phase.lifted_time, 0.);
  expect({friction, weight, 0., "in_phase", 0.4, 0.02}, [&](int i) { return 0.4 * P(i - 40); });
  expect({friction, weight, 0., "held", 0.3, 0.}, [&](int i) { return 0.3 * P(std::min(i, 150)); });
}

TEST(RespondSlip, AWaveThatPartsTheBottomHasItsReasonAndCostsNoOther) {
  WaveFile file = wave(fine_triangle(2e6));
  const Eigen::Index n = file.value.cols();
  file.value.conservativeResize(4, Eigen::NoChange);
  file.value.bottomRows(2) = 0.25 * file.value.topRows(2);
  ASSERT_EQ(n, file.value.cols());
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight, 0., "in_phase", 1., 0.};
  const std::vector<WaveResponse> waves = respond_to_waves(model_with_slip(), {file}, options)[0].waves;
  ASSERT_EQ(waves.size(), 2u);
  EXPECT_FALSE(waves[0].coupled);
  EXPECT_NE(waves[0].why_not_coupled.find("part from the ground"), std::string::npos) << waves[0].why_not_coupled;
  EXPECT_TRUE(waves[0].sliding);
  ASSERT_TRUE(waves[1].coupled);
  EXPECT_EQ(waves[1].why_not_coupled, "");
}

TEST(RespondSlip, ASlipThatIsNotWellPosedCostsNothingElse) {
  ReducedModelFile model = model_with_slip();
  model.slip->system.feedthrough(0, 2) = 2.;  // N' grows by twice the friction force
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight};
  const WaveResponse found = respond_to_waves(model, {wave(fine_triangle(2e6))}, options)[0].waves[0];
  EXPECT_FALSE(found.coupled);
  EXPECT_NE(found.why_not_coupled.find("not well posed"), std::string::npos) << found.why_not_coupled;
  EXPECT_TRUE(found.sliding);
}

TEST(RespondSlip, ComputedUpliftIsTheModels) {
  // x' serves as the uplift by pore pressure, with a factor that makes it large enough
  ReducedModelFile model = model_with_slip(), twin = model;
  ReducedSystem& system = model.slip->system;
  system.velocity(0, 0) = 3e5;
  system.reading_label[0].name = "uplift";
  system.reading_label.push_back({"normal_force", "N/m", "no change of N'"});
  for (Eigen::MatrixXd* part : {&system.position, &system.velocity, &system.acceleration, &system.feedthrough}) {
    part->conservativeResize(4, Eigen::NoChange);
    part->row(3).setZero();
  }
  twin.slip->system.velocity(0, 0) = -3e5;
  for (ReducedModelFile* m : {&model, &twin}) m->modes.reading_label[2].name = "uplift";
  const WaveFile file = wave(fine_triangle(2e6));
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight, 0., "computed"};
  const double computed = respond_to_waves(model, {file}, options)[0].waves[0].coupled->sliding;
  options.sliding->uplift = "none";
  const double none = respond_to_waves(model, {file}, options)[0].waves[0].coupled->sliding;
  const double by_normal_force = respond_to_waves(twin, {file}, options)[0].waves[0].coupled->sliding;
  EXPECT_NEAR(computed, by_normal_force, 1e-12);
  EXPECT_GT(std::abs(computed - none), 0.01 * std::abs(none));
}

TEST(RespondSlip, IsNotToldWithoutTheModelOrTheQuestion) {
  RespondOptions options;
  const WaveFile file = wave(triangle(3e6));
  EXPECT_FALSE(respond_to_waves(model_with_slip(), {file}, options)[0].waves[0].coupled);
  options.sliding = ModelSliding{friction, weight};
  const WaveResponse without = respond_to_waves(oscillator(), {file}, options)[0].waves[0];
  EXPECT_FALSE(without.coupled);
  const WaveResponse with = respond_to_waves(model_with_slip(), {file}, options)[0].waves[0];
  EXPECT_EQ(*without.sliding, *with.sliding);
}

TEST(RespondSlip, AWaveThatStaysBelowFrictionDoesNotSlip) {
  const CoupledWave found = slid(wave(fine_triangle(3e5)));
  EXPECT_EQ(found.sliding, 0.);
  EXPECT_EQ(found.slips, 0);
  EXPECT_EQ(found.dissipated, 0.);
}

TEST(RespondSlip, OtherLoadsThanTheModelsAreRefused) {
  ReducedModelFile model = model_with_slip();
  model.slip->system.load_name[1] = "fast";
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight};
  EXPECT_THROW(respond_to_waves(model, {wave(triangle(3e6))}, options), InputError);
}

TEST(RespondSlip, APorePressureFollowsItsLoad) {
  ReducedModelFile model = model_with_slip();
  ReducedSystem& system = model.slip->system;
  system.load_name = {"impact", "impact.pore_pressure", "slow", "interface/friction"};
  system.load.conservativeResize(2, 4);
  system.load << 0.75, 0.25, 1., 0., 0., 0., 0., -1.;
  system.prescribed.push_back(-1);
  system.feedthrough.setZero(3, 4);
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight};
  const WaveFile file = wave(fine_triangle(3e6));
  EXPECT_NEAR(respond_to_waves(model, {file}, options)[0].waves[0].coupled->sliding, slid(file).sliding, 1e-9);
}

/// Waves on the landward wall alone are the mirror image: U follows them, too.
TEST(RespondSlip, APrescribedUpliftFollowsWavesFromEitherSide) {
  ModelSliding sliding{friction, weight};
  sliding.uplift_per_force = 0.3;
  const std::vector<double> time{0., 0.1, 0.2, 0.3};
  const Eigen::RowVectorXd landward = (Eigen::RowVectorXd(4) << 0., 2e6, 1e6, 0.).finished();
  for (const std::string course : {"in_phase", "held"}) {
    sliding.uplift = course;
    const Eigen::RowVectorXd U = uplift_of_force(sliding, time, landward);
    EXPECT_EQ(U, uplift_of_force(sliding, time, -landward)) << course;
    EXPECT_EQ(U[1], 6e5);
  }
  Eigen::RowVectorXd both = landward;
  both[2] = -1e6;
  sliding.uplift = "in_phase";
  EXPECT_EQ(uplift_of_force(sliding, time, both)[2], 0.) << "the trough after a crest";
}

/// Where a record ends while the caisson slides it is braked by what is left of its weight.
TEST(RespondSlip, AnUpliftThatIsHeldStaysAfterTheRecord) {
  ModelSliding sliding{friction, weight};
  const double mass = 1e5, end = 0.2, uplift = 0.4 * weight, force = 2. * friction * weight;
  const std::vector<double> time{0., end};
  const auto constant = [](double value) { return Eigen::RowVectorXd(Eigen::RowVectorXd::Constant(2, value)); };
  for (const std::string course : {"in_phase", "held"}) {
    sliding.uplift = course;
    const double lifted = friction * (weight - uplift), a = (force - lifted) / mass, v = a * end;
    const double R = course == "held" ? lifted : friction * weight;
    const double S = 0.5 * a * end * end + 0.5 * mass * v * v / R;
    EXPECT_NEAR(sliding_distance(sliding, mass, time, constant(force), constant(uplift)), S, 1e-9 * S) << course;
  }
}

/// A record that ends above friction has no S of its own.
TEST(RespondSlip, LoadsThatStayAboveFrictionAreTold) {
  const ReducedModelFile model = model_with_slip();
  RespondOptions options;
  options.sliding = ModelSliding{friction, weight};
  const WaveFile ends = wave(triangle(3e6)), stays = wave({{0., 0.1, 0.2}, {0., 3e6, 3e6}});
  EXPECT_FALSE(respond_to_waves(model, {ends}, options)[0].waves[0].slides_on);
  EXPECT_TRUE(respond_to_waves(model, {stays}, options)[0].waves[0].slides_on);
}

}  // namespace respond_slip_test
}  // namespace upbead::test
