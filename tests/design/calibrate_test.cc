// Claim: tau_0 of a known pulse is found, the calibration does not depend on the size of the breakwater, and waves
// outside the range of the formulas are left out and counted.
#include "design/calibrate/calibration_report.h"

#include <algorithm>
#include <cmath>

#include "../output/sample_model.h"
#include "good_case.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace calibrate_test {

const std::string design_text = R"([section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 8.5
crest = 7.0
width = 18.0
berm_width = 8.0
bed_slope = 0.01
weight = 5.933e6
submerged_weight = 4.296e6

[calibration]
relative_height = [0.3, 0.5, 0.7]
period = [12.0]
relative_berm_depth = [0.35, 0.45]
relative_berm_width = [0.05, 0.12]
ratios = [1.05, 1.5, 2.5]

[calibration.models.full]
model = "full.h5"
load = "impact"

[calibration.models.small]
model = "small.h5"
load = "impact"
scale = 0.05
)";

Calibration calibration_of(const std::string& path, const std::vector<std::string>& overrides = {}) {
  return calibrate(read_design(path, overrides, {check_calibration}));
}

/// The same caisson at another length scale: times scale with its square root, forces with mass times acceleration.
ReducedModelFile at_scale(ReducedModelFile model, double scale) {
  const double rate = 1. / std::sqrt(scale);
  model.modes.pole *= rate;
  model.modes.reading.row(1) *= rate;  // F_T after a unit impulse of P, in 1/s
  model.caisson_mass *= scale * scale;
  return model;
}

/// F_T = P without delay.
ReducedModelFile stiff() {
  ReducedModelFile model = oscillator();
  model.modes.reading.row(1).setZero();
  model.modes.feedthrough.row(1).setOnes();
  return model;
}

/// P is only a symmetric triangle over half the period: it rises slowly, and its impulse exceeds that of the standing
/// wave. U is in phase with P.
const std::vector<std::string> as_triangle{"impact.peak_gain=2", "impact.rise_coefficient=100",
                                           "impact.uplift=in_phase"};

class CalibrateTest : public InFolder {
 protected:
  CalibrateTest() { write("design.toml", design_text); }

  void write_models(const ReducedModelFile& full) {
    write("full.h5", model_file(full));
    write("small.h5", model_file(at_scale(full, 0.05)));
  }
};

const CalibrationFit& fit_of(const CalibratedModel& model, DurationMeasure measure, std::optional<double> ratio) {
  return *std::find_if(model.fits.begin(), model.fits.end(),
                       [&](const CalibrationFit& fit) { return fit.measure == measure && fit.ratio == ratio; });
}

TEST_F(CalibrateTest, FindsTheDurationOfATriangleOnAStiffGround) {
  write_models(stiff());
  const Calibration found = calibration_of("design.toml", as_triangle);
  ASSERT_EQ(found.n_waves, 12U);
  for (const CalibratedModel& model : found.models)
    for (const CalibratedWave& wave : model.waves) {
      ASSERT_EQ(wave.impact.reduction, 0.) << "no standing part";
      ASSERT_EQ(wave.durations.size(), 3U);
      EXPECT_NEAR(wave.peak_shear, wave.impact.peak, 1e-9 * wave.impact.peak);
      EXPECT_NEAR(wave.peak_sliding_force, wave.impact.peak + 0.6 * wave.impact.uplift, 1e-9 * wave.impact.peak);
      const double expected = 0.5 * wave.period;
      EXPECT_NEAR(wave.tau_0F, (0.5 - wave.height / (8. * 15. * model.scale)) * wave.period, 1e-12);
      for (const WaveDuration& duration : wave.durations) {
        for (const auto measure : {DurationMeasure::exact, DurationMeasure::excess, DurationMeasure::impulse})
          EXPECT_NEAR(duration.tau_0.at(measure), expected, 1e-7 * expected) << word(measure);
        EXPECT_GT(duration.tau_0.at(DurationMeasure::paper), expected) << "eq. (7) slides less";
      }
      // At r = 1.5 the exact S is 1.554 times that of eq. (7), and S grows with the square of tau_0.
      EXPECT_NEAR(wave.durations[1].tau_0.at(DurationMeasure::paper), expected * std::sqrt(1.5543), 1e-4 * expected);
    }
}

TEST_F(CalibrateTest, DoesNotDependOnTheSize) {
  write_models(oscillator());
  const Calibration found = calibration_of("design.toml");
  ASSERT_EQ(found.models.size(), 2U);
  const CalibratedModel &full = found.models[0], &small = found.models[1];
  ASSERT_EQ(full.name, "full");
  EXPECT_NEAR(small.step / full.step, std::sqrt(0.05), 1e-12);
  for (std::size_t i = 0; i < full.waves.size(); ++i) {
    const CalibratedWave &large = full.waves[i], &little = small.waves[i];
    EXPECT_NEAR(little.peak_shear / large.peak_shear, 0.05 * 0.05, 1e-10);
    EXPECT_NE(large.peak_shear, large.impact.peak) << "the ground does something";
    EXPECT_EQ(little.alpha_star, large.alpha_star);
    ASSERT_EQ(large.durations.size(), little.durations.size());
    for (std::size_t r = 0; r < large.durations.size(); ++r)
      for (const auto& [measure, tau_0] : large.durations[r].tau_0)
        EXPECT_NEAR(little.durations[r].tau_0.at(measure) / little.tau_0F, tau_0 / large.tau_0F, 1e-8) << i;
  }
  const auto &a = fit_of(full, DurationMeasure::exact, 1.5).fit, &b = fit_of(small, DurationMeasure::exact, 1.5).fit;
  EXPECT_NEAR(a->best.a, b->best.a, 1e-5);
  EXPECT_NEAR(a->best.b, b->best.b, 1e-5);
}

TEST_F(CalibrateTest, FitsEveryMeasureAtEveryRatioAndAllTogether) {
  write_models(oscillator());
  const Calibration found = calibration_of("design.toml");
  const CalibratedModel& model = found.models.front();
  EXPECT_EQ(model.fits.size(), 13U);
  for (const DurationMeasure measure : {DurationMeasure::paper, DurationMeasure::exact, DurationMeasure::excess}) {
    EXPECT_EQ(fit_of(model, measure, 1.05).points.size(), 12U);
    EXPECT_EQ(fit_of(model, measure, std::nullopt).points.size(), 36U);
  }
  EXPECT_EQ(fit_of(model, DurationMeasure::impulse, std::nullopt).points.size(), 12U) << "the same at every r";
  const CalibrationFit& fit = fit_of(model, DurationMeasure::exact, 1.05);
  EXPECT_EQ(fit.points[3].alpha_star, model.waves[3].alpha_star);
  EXPECT_EQ(fit.points[3].k, model.waves[3].durations[0].tau_0.at(DurationMeasure::exact) / model.waves[3].tau_0F);
  EXPECT_LT(fit.fit->quality.deviation, fit.given.deviation) << "no a and b are better than the fitted ones";
}

TEST_F(CalibrateTest, LeavesOutWhatIsBeyondTheFormulas) {
  write_models(oscillator());
  const auto left = [](const std::vector<std::string>& overrides) {
    return calibration_of("design.toml", overrides).left;
  };
  using Left = std::map<std::string, std::size_t>;
  EXPECT_EQ(left({}), Left{});
  EXPECT_EQ(left({"calibration.relative_height=[0.3, 0.8]", "calibration.period=[15]"}), Left{})
      << "0.8 itself is within";
  EXPECT_EQ(left({"calibration.relative_height=[0.3, 0.81]", "calibration.period=[15]"}),
            (Left{{"height_over_depth", 4}}));
  EXPECT_EQ(left({"calibration.relative_berm_depth=[0.45, 0.6]"}), Left{}) << "d = h'";
  EXPECT_EQ(left({"calibration.relative_berm_depth=[0.45, 0.61]"}), (Left{{"berm_below_caisson", 6}}));
  EXPECT_EQ(left({"calibration.period=[6, 12]"}), (Left{{"breaking_limit", 8}}));
  EXPECT_EQ(left({"calibration.steepness=[0.04, 0.14]"}), (Left{{"steepness", 4}}));
  const Calibration found = calibration_of("design.toml", {"calibration.steepness=[0.04, 0.14]"});
  EXPECT_EQ(found.n_grid, 12U);
  EXPECT_EQ(found.n_waves, 8U);
  EXPECT_EQ(found.models[0].waves.size(), 8U);
}

TEST_F(CalibrateTest, TakesRangesForLists) {
  write_models(oscillator());
  const Calibration list = calibration_of("design.toml");
  const Calibration range =
      calibration_of("design.toml", {"calibration.relative_height={ from = 0.3, to = 0.7, n = 3 }"});
  ASSERT_EQ(range.n_waves, list.n_waves);
  for (std::size_t i = 0; i < list.n_waves; ++i)
    EXPECT_NEAR(range.models[0].waves[i].height, list.models[0].waves[i].height, 1e-12);
}

TEST_F(CalibrateTest, AWaveThatNothingPushesLandwardHasNoDuration) {
  ReducedModelFile model = stiff();
  model.modes.feedthrough.row(1).setConstant(-1.);
  write_models(model);
  const Calibration found = calibration_of("design.toml", as_triangle);
  EXPECT_TRUE(found.models[0].waves[0].durations.empty());
  for (const CalibrationFit& fit : found.models[0].fits) EXPECT_FALSE(fit.fit);
}

}  // namespace calibrate_test
}  // namespace upbead::test
