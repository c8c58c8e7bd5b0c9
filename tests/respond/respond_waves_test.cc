// Claim: the response to a wave is that to its straight lines and jumps, however its times are spaced; peaks, ratios
// and the part beyond the model's frequencies are determined as in a run.
#include "respond/respond_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../output/sample_model.h"
#include "respond/respond_warnings.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/sliding/block.h"

namespace upbead::test {

namespace respond_waves_test {

using Times = std::vector<double>;

WaveFile wave(const Times& time, const Times& impact) {
  WaveFile file{"w", time, WaveSamples::Zero(2, static_cast<Eigen::Index>(time.size())), 2, {}};
  for (std::size_t n = 0; n < time.size(); ++n) file.value(0, static_cast<Eigen::Index>(n)) = impact[n];
  return file;
}

/// A triangle of 0.15 s on equal steps.
WaveFile triangle(double step, double peak = 1.6e6, double duration = 0.15) {
  Times time, value;
  for (int n = 0; n * step < duration + 0.5 * step; ++n) {
    time.push_back(n * step);
    value.push_back(peak * std::max(0., 1. - std::abs(2. * n * step / duration - 1.)));
  }
  return wave(time, value);
}

WaveResponses answer(const WaveFile& file, const RespondOptions& options = {}) {
  return respond_to_waves(oscillator(), {file}, options).front();
}

/// Largest difference of F_T to the exact response to a function of time at the same times, over the largest F_T.
double error(const WaveResponses& found, const TimeFunction& impact) {
  const ModalModel model = oscillator().modes;
  const auto exact = respond(model, sample({impact, TimeFunction()}, found.time)).reading.row(1).eval();
  return (found.shear_force.row(0) - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

TEST(RespondWaves, SpacingOfTimesDoesNotMatter) {
  const TimeFunction exact = piecewise_linear({0., 0.075, 0.15}, {0., 1.6e6, 0.});
  EXPECT_LT(error(answer(triangle(0.0005)), exact), 1e-12) << "fine and equal";
  EXPECT_LT(error(answer(triangle(0.0375)), exact), 1e-12) << "equal, but too coarse to read a peak";
  EXPECT_LT(error(answer(wave({0., 0.0749, 0.075, 0.15}, {0., 0.0749 / 0.075 * 1.6e6, 1.6e6, 0.})), exact), 1e-12);
}

TEST(RespondWaves, AWaveJumpsWhereItBeginsAndEnds) {
  const Times time{0.1, 0.25, 0.9}, value{2e6, 1e6, 3e5};
  EXPECT_LT(error(answer(wave(time, value)), piecewise_linear(time, value)), 1e-12);
}

TEST(RespondWaves, AWaveOnEqualStepsJumpsWhereItEnds) {
  Times time, value;
  for (int n = 0; n <= 500; ++n) {
    time.push_back(1e-3 * n);
    value.push_back(2e3 * n);
  }
  const WaveResponses found = answer(wave(time, value));
  EXPECT_LT(error(found, piecewise_linear({0., 0.5}, {0., 1e6})), 1e-12);
  EXPECT_EQ(found.force(0, 500), 1e6);
  EXPECT_EQ(found.force(0, 501), 0.);
}

TEST(RespondWaves, AnswersAsLongAsTheWaveOrTheCaseOrAsAsked) {
  EXPECT_NEAR(answer(triangle(0.0005)).time.back(), 4., 1e-12);
  EXPECT_NEAR(answer(wave({0., 5., 6.}, {0., 1., 1.})).time.back(), 6., 1e-12) << "cut off under load";
  RespondOptions options;
  options.end = 0.1;
  for (const WaveFile& file : {triangle(0.0005), triangle(0.0375)}) {
    const WaveResponses found = answer(file, options);
    EXPECT_NEAR(found.time.back(), 0.1, 1e-12);
    EXPECT_LT(error(found, piecewise_linear({0., 0.075, 0.15}, {0., 1.6e6, 0.})), 1e-12);
  }
  options.end = 1e6;
  EXPECT_THROW(answer(triangle(0.0005), options), InputError);
}

TEST(RespondWaves, AWaveAfterTheCaseRingsDownAsOneWithinIt) {
  const double step = 0.0005;
  WaveFile late = triangle(step);
  const auto n = late.value.cols();
  for (const double start : {3.8, 20.}) {
    WaveFile file = triangle(step, 0., start + 0.15);
    file.value.row(0).rightCols(n) = late.value.row(0);
    const WaveResponse found = answer(file).waves[0], own = answer(late).waves[0];
    EXPECT_NEAR(found.peak_shear_seaward, own.peak_shear_seaward, 1e-6 * own.peak_shear) << start;
    EXPECT_LT(own.peak_shear_seaward, -0.1 * own.peak_shear) << "it swings back";
    // the case was given 1 s after its longest load, less than three periods of 0.506 s
    EXPECT_NEAR(answer(file).time.back(), start + 0.15 + 1., 2. * step);
    file.rings_down = true;
    EXPECT_NEAR(answer(file).time.back(), std::max(start + 0.15, 4.), 2. * step) << "as long as its case asks";
  }
}

TEST(RespondWaves, ACaseThatEndsWithItsLoadDoesNotCutTheReboundOfAWave) {
  ReducedModelFile brief = oscillator(), whole = oscillator();
  brief.end = 0.15;
  for (ModelLoad& load : brief.loads) load.duration = brief.end;
  const WaveFile file = triangle(0.0005);
  const WaveResponses found = respond_to_waves(brief, {file}, {}).front(),
                      expected = respond_to_waves(whole, {file}, {}).front();
  EXPECT_NEAR(found.waves[0].peak_shear_seaward, expected.waves[0].peak_shear_seaward,
              1e-9 * expected.waves[0].peak_shear);
  EXPECT_NEAR(found.time.back(), 0.15 + 0.75 * swing_period_of(brief.modes), 2e-3);
}

NumberedWarnings told_of_end(const WaveFile& file, double end) {
  const ReducedModelFile model = oscillator();
  RespondOptions options;
  options.end = end;
  return cut_warnings(model, {file}, respond_to_waves(model, {file}, options));
}

TEST(RespondWaves, AnEndThatCutsAWaveOrItsAnswerIsTold) {
  const WaveFile file = triangle(0.0005);
  EXPECT_TRUE(told_of_end(file, 0.6).empty());
  for (const auto& [end, name] : {std::pair(0.05, "load_cut"), std::pair(0.16, "answer_cut")}) {
    const NumberedWarnings list = told_of_end(file, end);
    ASSERT_EQ(list.size(), 1U) << end;
    EXPECT_EQ(list[0].name, name);
    EXPECT_TRUE(list[0].voids);
    EXPECT_NE(list[0].cure.find("--end"), std::string::npos);
  }
}

TEST(RespondWaves, TellsOfALoadOfTheCaseThatNoWaveHas) {
  ReducedModelFile model = oscillator();
  WaveFile lacks = triangle(0.0005), has = lacks;
  has.value.row(1).setConstant(1e3);
  const auto is_told = [&model](const std::vector<WaveFile>& files) {
    const NumberedWarnings list = force_warnings(model, files, {});
    return std::any_of(list.begin(), list.end(), [](const auto& one) { return one.name == "load_left_out"; });
  };
  model.loads[1].peak = 2e3;
  EXPECT_TRUE(is_told({lacks}));
  EXPECT_FALSE(is_told({lacks, has}));
  model.loads[1].peak = 0.;
  EXPECT_FALSE(is_told({lacks}));
}

TEST(RespondWaves, PeaksAreFoundBetweenTheSamples) {
  const WaveResponse coarse = answer(triangle(0.0009375)).waves[0], fine = answer(triangle(0.00009375)).waves[0];
  EXPECT_NEAR(coarse.peak_shear, fine.peak_shear, 1e-7 * fine.peak_shear);
  EXPECT_NEAR(coarse.peak_shear_time, fine.peak_shear_time, 1e-5);
  EXPECT_EQ(coarse.peak_force, 1.6e6);
  EXPECT_NEAR(*coarse.ratio, coarse.peak_shear / 1.6e6, 1e-15);
}

TEST(RespondWaves, ASeawardWaveHasTheSameRatio) {
  const WaveResponse landward = answer(triangle(0.0005)).waves[0], seaward = answer(triangle(0.0005, -1.6e6)).waves[0];
  EXPECT_NEAR(seaward.peak_shear_seaward, -landward.peak_shear, 1e-6);
  EXPECT_EQ(seaward.peak_force_seaward, -landward.peak_force);
  EXPECT_NEAR(*seaward.ratio, *landward.ratio, 1e-12);
}

TEST(RespondWaves, NoWaveHasNoRatio) {
  const WaveResponse none = answer(triangle(0.0005, 0.)).waves[0];
  EXPECT_EQ(none.ratio, std::nullopt);
  EXPECT_EQ(none.peak_shear, 0.);
  EXPECT_EQ(none.beyond_band, 0.);
}

TEST(RespondWaves, OnlyShortWavesLieBeyondTheBand) {
  EXPECT_LT(answer(triangle(0.0005)).waves[0].beyond_band, 1e-3);
  const double on_steps = answer(triangle(0.00025, 1.6e6, 0.005)).waves[0].beyond_band;
  const double by_corners = answer(wave({0., 0.0025, 0.005}, {0., 1.6e6, 0.})).waves[0].beyond_band;
  EXPECT_GT(on_steps, 0.01);
  EXPECT_NEAR(by_corners, on_steps, 0.05 * on_steps);
}

TEST(RespondWaves, TellsTheErrorOfEachWave) {
  EXPECT_EQ(answer(triangle(0.0005)).waves[0].error_estimate, std::nullopt) << "a model that cannot tell";
  ReducedModelFile model = oscillator();
  model.nested = nested_oscillators(1.02, 1.03);
  const double bound = 1.2 * 0.03 + 1.5 * 0.01;  // the three models differ only by these factors
  for (const WaveFile& file : {triangle(0.0005), triangle(0.0375), wave({0., 0.0749, 0.075, 0.15}, {0., 1., 1.2, 0.})})
    EXPECT_NEAR(*respond_to_waves(model, {file}, {}).front().waves[0].error_estimate, bound, 0.02 * bound);
  EXPECT_EQ(respond_to_waves(model, {triangle(0.0005, 0.)}, {}).front().waves[0].error_estimate, 0.) << "no wave";
}

TEST(RespondWaves, TellsOfAnUpliftThatItLeavesOut) {
  ReducedModelFile model = oscillator();
  for (const bool is_record : {false, true}) {
    model.sliding = ModelSliding{0.6, 1e6, 0., is_record ? "history" : "in_phase"};
    for (const bool judged : {false, true}) {  // without that uplift S and factors are no result, F_T is
      RespondOptions options;
      if (judged) options.sliding = ModelSliding{0.6, 1e6};
      int told = 0, voids = 0;
      for (const NumberedWarning& warning :
           warnings_of_answers(model, respond_to_waves(model, {triangle(0.0005)}, options)))
        if (warning.name == "uplift_left_out") ++told, voids += warning.voids;
      EXPECT_EQ(told, is_record);
      EXPECT_EQ(voids, is_record && judged);
    }
  }
}

TEST(RespondWaves, SlidesAsTheBlockDoesUnderTheWholeHistory) {
  RespondOptions options;
  options.sliding = ModelSliding{1., 7e5};
  const WaveResponses found = answer(triangle(0.0005), options);
  const auto F = found.shear_force.row(0);
  const double S = slide(oscillator().caisson_mass, {found.time, {F.begin(), F.end()}}, 7e5).residual;
  EXPECT_GT(S, 0.);
  EXPECT_NEAR(*found.waves[0].sliding, S, 1e-12 * S);
  options.sliding->submerged_weight = 7e6;
  EXPECT_EQ(*answer(triangle(0.0005), options).waves[0].sliding, 0.);
}

/// S of a wave by hand: F_T against mu (W' - U), U at the same times.
double sliding_by_hand(const WaveResponses& found, double friction, double weight, const std::vector<double>& U) {
  const auto F = found.shear_force.row(0);
  History resistance{found.time, {}};
  for (const double u : U) resistance.value.push_back(friction * (weight - u));
  resistance.time.push_back(found.time.back());
  resistance.value.push_back(friction * weight);
  return slide(oscillator().caisson_mass, {found.time, {F.begin(), F.end()}}, resistance).residual;
}

TEST(RespondWaves, UpliftFollowsTheForceOrIsHeld) {
  RespondOptions options;
  options.sliding = ModelSliding{0.6, 1.1e6, 0., "in_phase", 0.5, 0.};
  const WaveResponses found = answer(triangle(0.0005), options);
  std::vector<double> U, held;
  const auto P = found.force.row(0);
  for (Eigen::Index i = 0; i < P.size(); ++i) {
    U.push_back(0.5 * std::max(P[i], 0.));
    held.push_back(std::max(U.back(), i == 0 || P[i] >= P[i - 1] ? 0. : 0.5 * P.maxCoeff()));
    if (i > 0 && held[static_cast<std::size_t>(i - 1)] >= 0.5 * P.maxCoeff()) held.back() = 0.5 * P.maxCoeff();
  }
  const double S = sliding_by_hand(found, 0.6, 1.1e6, U);
  EXPECT_GT(S, 0.);
  EXPECT_NEAR(*found.waves[0].sliding, S, 1e-12 * S);
  options.sliding->uplift = "held";
  const double more = *answer(triangle(0.0005), options).waves[0].sliding;
  EXPECT_NEAR(more, sliding_by_hand(found, 0.6, 1.1e6, held), 1e-12 * more);
  EXPECT_GT(more, 1.1 * S);
  options.sliding->uplift = "none";
  EXPECT_LT(*answer(triangle(0.0005), options).waves[0].sliding, S);
}

TEST(RespondWaves, UpliftMayLag) {
  RespondOptions options;
  options.sliding = ModelSliding{0.6, 1.1e6, 0., "in_phase", 0.5, 0.01};
  const WaveResponses found = answer(triangle(0.0005), options);
  const auto P = found.force.row(0);
  std::vector<double> U;
  for (Eigen::Index i = 0; i < P.size(); ++i) U.push_back(i < 20 ? 0. : 0.5 * std::max(P[i - 20], 0.));
  const double S = sliding_by_hand(found, 0.6, 1.1e6, U);
  EXPECT_GT(S, 0.);
  EXPECT_NEAR(*found.waves[0].sliding, S, 1e-9 * S);
}

TEST(RespondWaves, UpliftMayBeTheModels) {
  // x_G serves as the uplift by pore pressure, with a factor that makes it large enough
  ReducedModelFile model = oscillator();
  const int i = model.modes.index("caisson/displacement_x");
  model.modes.reading_label[static_cast<std::size_t>(i)].name = "uplift";
  model.modes.reading.row(i) *= 2e7;
  RespondOptions options;
  options.sliding = ModelSliding{0.6, 1.1e6, 0., "computed"};
  const WaveResponses found = respond_to_waves(model, {triangle(0.0005)}, options)[0];
  options.sliding->uplift = "none";
  const double without = *respond_to_waves(model, {triangle(0.0005)}, options)[0].waves[0].sliding;
  EXPECT_GT(*found.waves[0].sliding, 1.01 * without);
  EXPECT_GT(without, 0.);
}

TEST(RespondWaves, TellsWhyAModelHasNoCoupledSlipWhereSIsAskedFor) {
  RespondOptions options;
  options.why_no_slip = "it sticks";
  EXPECT_EQ(answer(triangle(0.0005), options).waves[0].why_not_coupled, "") << "nobody asked for S";
  options.sliding = ModelSliding{0.6, 1.1e6};
  EXPECT_EQ(answer(triangle(0.0005), options).waves[0].why_not_coupled, "it sticks");
}

TEST(RespondWaves, ManyWavesAreAnsweredEachByItself) {
  const int n = 50;
  WaveFile many = triangle(0.0005);
  const WaveSamples one = many.value;
  many.value.resize(2 * n, one.cols());
  for (int w = 0; w < n; ++w) many.value.middleRows(2 * w, 2) = (w + 1.) * one;
  const WaveResponses found = answer(many), alone = answer(triangle(0.0005));
  ASSERT_EQ(found.waves.size(), 50U);
  for (int w = 0; w < n; ++w)
    EXPECT_NEAR(found.waves[static_cast<std::size_t>(w)].peak_shear, (w + 1.) * alone.waves[0].peak_shear, 1e-6);
  EXPECT_EQ(found.wave_name(3), "w[3]");
  EXPECT_EQ(alone.wave_name(0), "w");
}

TEST(RespondWaves, AModelWithoutACaissonIsRefused) {
  ReducedModelFile model = oscillator();
  model.modes.reading_label[1].name = "probes/A/pressure";
  try {
    respond_to_waves(model, {triangle(0.0005)}, {});
    FAIL() << "answered";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "the model has no readings 'force' and 'shear_force': its mesh has no surface 'caisson'; reduce a case "
        "with a caisson");
  }
}

}  // namespace respond_waves_test
}  // namespace upbead::test
