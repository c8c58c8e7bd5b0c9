#include "calibration_fits.h"

namespace upbead {

namespace {

CalibrationFit fit(const CalibratedModel& model, DurationMeasure measure, std::optional<double> ratio,
                   const DurationFactor& given) {
  CalibrationFit out;
  out.measure = measure;
  out.ratio = ratio;
  for (const CalibratedWave& wave : model.waves)
    for (const WaveDuration& duration : wave.durations) {
      const auto tau_0 = duration.tau_0.find(measure);
      if (tau_0 != duration.tau_0.end() && (!ratio || duration.ratio == *ratio))
        out.points.push_back({wave.alpha_star, tau_0->second / wave.tau_0F});
    }
  out.fit = fit_duration_factor(out.points);
  if (!out.points.empty()) out.given = quality(out.points, given);
  out.given_in_ellipse = out.fit && in_ellipse(*out.fit, given);
  return out;
}

}  // namespace

const char* word(DurationMeasure measure) {
  switch (measure) {
    case DurationMeasure::paper:
      return "paper";
    case DurationMeasure::exact:
      return "exact";
    case DurationMeasure::excess:
      return "excess";
    case DurationMeasure::impulse:
      break;
  }
  return "impulse";
}

std::vector<CalibrationFit> fits(const CalibratedModel& model, const std::vector<double>& ratios,
                                 const DurationFactor& given) {
  std::vector<CalibrationFit> list;
  for (const DurationMeasure measure : {DurationMeasure::paper, DurationMeasure::exact, DurationMeasure::excess}) {
    for (const double ratio : ratios) list.push_back(fit(model, measure, ratio, given));
    list.push_back(fit(model, measure, std::nullopt, given));
  }
  list.push_back(fit(model, DurationMeasure::impulse, ratios.front(), given));
  list.back().ratio.reset();
  return list;
}

}  // namespace upbead
