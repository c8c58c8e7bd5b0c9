#include <algorithm>
#include <cmath>

#include "calibration_report.h"
#include "output/output_schema.h"

namespace upbead {

namespace {

/// All that goes into summary.json of `calibrate`.
struct ToldCalibration {
  const Design* design;
  const Calibration* found;
  NumberedWarnings warnings;
};

OutputSchema<FitQuality> quality_outputs() {
  using Q = FitQuality;
  return OutputSchema<Q>()
      .key("deviation", &Q::deviation, "", "root mean square of k - k(alpha*)")
      .key("bias", &Q::bias, "", "mean of k(alpha*) - k")
      .key("r_squared", &Q::r_squared, "", "R2");
}

/// The confidence ellipse in the plane of (a, b): semi-axes and the direction of the longer one.
OutputSchema<DurationFit> ellipse_outputs() {
  using F = DurationFit;
  const auto axis = [](double sign) {
    return [sign](const F& fit) {
      const double aa = fit.covariance(0, 0), bb = fit.covariance(1, 1), ab = fit.covariance(0, 1);
      const double mean = 0.5 * (aa + bb), radius = std::hypot(0.5 * (aa - bb), ab);
      return std::sqrt(ellipse_size(fit) * std::max(mean + sign * radius, 0.));
    };
  };
  const auto angle = [](const F& fit) {
    return 0.5 * std::atan2(2. * fit.covariance(0, 1), fit.covariance(0, 0) - fit.covariance(1, 1));
  };
  return OutputSchema<F>()
      .key(
          "level", [](const F&) { return 0.95; }, "", "of confidence")
      .key("long_axis", axis(1.), "", "semi-axis")
      .key("short_axis", axis(-1.), "", "semi-axis")
      .key("angle", angle, "rad", "of the long axis from the a-axis");
}

OutputSchema<CalibrationFit> certainty_outputs() {
  using F = DurationFit;
  const auto certain = [](const CalibrationFit& c) { return c.fit && c.fit->has_covariance() ? &*c.fit : nullptr; };
  const auto deviation = [](int i) { return [i](const F& fit) { return std::sqrt(fit.covariance(i, i)); }; };
  const auto covariance = [](const F& fit) {
    const Eigen::Matrix2d& C = fit.covariance;
    return Json{{C(0, 0), C(0, 1)}, {C(1, 0), C(1, 1)}};
  };
  const auto correlation = [deviation](const F& fit) {
    const double a = deviation(0)(fit), b = deviation(1)(fit);  // 0 where the formula fits all points exactly
    return a == 0. || b == 0. ? std::nullopt : std::optional(fit.covariance(0, 1) / (a * b));
  };
  return OutputSchema<CalibrationFit>()
      .object("standard_error", certain,
              OutputSchema<F>().key("a", deviation(0), "", "of a").key("b", deviation(1), "", "of b"),
              "null where the fit is doubted, as the next three")
      .keys_of(certain, OutputSchema<F>()
                            .key("covariance[]", covariance, "", "of (a, b)")
                            .key("correlation", correlation, "", "of a and b; null where both are exact"))
      .object("ellipse", certain, ellipse_outputs(), "of (a, b), 95 %");
}

OutputSchema<CalibrationFit> fit_outputs() {
  using C = CalibrationFit;
  using F = DurationFit;
  return OutputSchema<C>()
      .key(
          "measure", [](const C& c) { return word(c.measure); }, "", "of tau_0")
      .key("ratio", &C::ratio, "", "r; null: all r")
      .key("points", inner(&C::points, &std::vector<DurationPoint>::size), "", "how many")
      .key("a", inner(&C::fit, &F::best, &DurationFactor::a), "", "of k(alpha*); null with too few points, as b")
      .key("b", inner(&C::fit, &F::best, &DurationFactor::b), "", "of k(alpha*)")
      .keys_of([](const C& c) { return &c; }, certainty_outputs())
      .key("residual_deviation", inner(&C::fit, &F::residual_deviation), "",
           "sqrt(sum of squares / (points - 2)); absent without a fit, as `quality`")
      .or_left_out()
      .object("quality", inner(&C::fit, &F::quality), quality_outputs(), "of the fit")
      .or_left_out()
      .key(
          "doubt", [](const C& c) { return c.fit ? word(c.fit->doubt) : "too_few"; }, "",
          "why the points do not tell a and b; `none` where they do")
      .object("given", &C::given, quality_outputs(), "of the design's own a and b")
      .key("given_in_ellipse", &C::given_in_ellipse, "", "whether the ellipse holds these");
}

OutputSchema<CalibrationFit> recommended_outputs() {
  using C = CalibrationFit;
  using F = DurationFit;
  return OutputSchema<C>()
      .key(
          "measure", [](const C& c) { return word(c.measure); }, "", "of tau_0")
      .key("ratio", &C::ratio, "", "r; null: all r")
      .key("a", inner(&C::fit, &F::best, &DurationFactor::a), "", "of k(alpha*)")
      .key("b", inner(&C::fit, &F::best, &DurationFactor::b), "", "of k(alpha*)")
      .key("residual_deviation", inner(&C::fit, &F::residual_deviation), "", "of k");
}

OutputSchema<CalibratedSoil> calibrated_soil_outputs() {
  using S = CalibratedSoil;
  using F = DurationFit;
  return OutputSchema<S>()
      .key("soil.KEY", &S::soil, "", "value of each key of the box")
      .key("error", &S::error, "", "estimated, of the model's history of F_T over its peak")
      .key("a", inner(&S::fit, &F::best, &DurationFactor::a), "",
           "of its own recommended k(alpha*); null where all fits are doubted")
      .key("b", inner(&S::fit, &F::best, &DurationFactor::b), "", "of its own recommended k(alpha*)");
}

OutputSchema<CalibratedModel> calibrated_model_outputs() {
  using M = CalibratedModel;
  return OutputSchema<M>()
      .key("title", &M::title, "", "that of its case")
      .key("load", &M::load, "", "that the waves drive")
      .key("scale", &M::scale, "", "of its lengths")
      .key("step", &M::step, "s", "of all answers")
      .key("shortest_rise", &M::shortest_rise, "s", "of all waves")
      .object(
          "recommended", [](const M& m) { return recommended(m); }, recommended_outputs(),
          "the fit to take for design: of S itself, at all r; where that is doubted the one of `exact` with the least "
          "residual that is not; null where all are")
      .list("fits[]", &M::fits, fit_outputs(), "by measure and r")
      .list("soils[]", &M::soils, calibrated_soil_outputs(), "of a [model of soils](soils.md): each, and its own fit");
}

OutputSchema<ImpactTable> impact_table_outputs() {
  using I = ImpactTable;
  const auto uplift = [](const I& impact) {
    const char* const words[] = {"held", "in_phase", "sinusoidal"};
    return words[static_cast<int>(impact.uplift)];
  };
  return OutputSchema<I>()
      .key("peak_gain", &I::peak_gain, "", "as used; null: as much as makes P_I Goda's P with alpha*")
      .key("rise_coefficient", &I::rise_coefficient, "", "as used")
      .key("duration_least", &I::duration_least, "", "as used")
      .key("duration_gain", &I::duration_gain, "", "as used")
      .key("duration_decay", &I::duration_decay, "", "as used")
      .key("uplift", uplift, "", "`held`, `in_phase` or `sinusoidal`");
}

const OutputSchema<ToldCalibration>& calibration_outputs() {
  using T = ToldCalibration;
  using C = Calibration;
  const auto waves = OutputSchema<C>()
                         .key("grid", &C::n_grid, "", "points of the grid")
                         .key("taken", &C::n_waves, "", "of them waves that can be")
                         .key("left_out.REASON", &C::left, "", "the others");
  const auto factor = OutputSchema<DurationFactor>()
                          .key("a", &DurationFactor::a, "", "of `[duration]`")
                          .key("b", &DurationFactor::b, "", "of `[duration]`");
  static const auto schema =
      OutputSchema<T>()
          .key("title", inner(&T::design, &Design::tables, &DesignTables::title), "", "that of the design")
          .program()
          .list("warnings[]", &T::warnings, warning_outputs(), "fits that do not tell a and b")
          .object("waves", &T::found, waves, "of the family")
          .object("impact", inner(&T::design, &Design::tables, &DesignTables::impact), impact_table_outputs(),
                  "the force history")
          .object("given", inner(&T::found, &C::given), factor, "k(alpha*) of the design")
          .named("models.NAME", inner(&T::found, &C::models), &CalibratedModel::name, calibrated_model_outputs(),
                 "each model")
          .object("timing", &T::found, OutputSchema<C>().key("calibrate", &C::seconds, "s", "all of it"), "wall times")
          .versions();
  return schema;
}

}  // namespace

std::vector<OutputRow> rows_of_calibration() {
  return calibration_outputs().rows();
}

Json to_json(const Design& design, const Calibration& found) {
  return calibration_outputs().to_json({&design, &found, warnings_of(design, found)});
}

}  // namespace upbead
