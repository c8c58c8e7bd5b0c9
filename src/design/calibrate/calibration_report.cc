#include "calibration_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.h"

namespace upbead {

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string name_of(const std::optional<double>& ratio) {
  return ratio ? significant(*ratio, 4) : "all";
}

/// "0.30 +- 0.01"; without the error where it means nothing.
std::string estimate(const DurationFit& fit, double value, int index) {
  if (!fit.has_covariance()) return format("%.4g", value);
  return format("%.4g +- %.2g", value, std::sqrt(fit.covariance(index, index)));
}

std::string remark(const CalibrationFit& found) {
  if (!found.fit) return "too few waves";
  switch (found.fit->doubt) {
    case FitDoubt::edge:
      return "not identifiable: runs to the end of its range";
    case FitDoubt::ill_conditioned:
      return "not identifiable: a and b cannot be told apart";
    case FitDoubt::reaches_zero:
      return "the ellipse reaches 0";
    case FitDoubt::none:
      break;
  }
  return found.given_in_ellipse ? "holds the given a, b" : "";
}

std::string row(const CalibrationFit& found) {
  const std::string head = format("  %-8s %-5s %6d  ", word(found.measure), name_of(found.ratio).c_str(),
                                  static_cast<int>(found.points.size()));
  const std::string given = format("%8.3f %8.2f  ", found.given.deviation, found.given.r_squared);
  if (!found.fit) return head + format("%-16s %-16s %8s %8s ", "-", "-", "-", "-") + given + remark(found) + "\n";
  const DurationFit& fit = *found.fit;
  return head +
         format("%-16s %-16s %8.3f %8.2f ", estimate(fit, fit.best.a, 0).c_str(), estimate(fit, fit.best.b, 1).c_str(),
                fit.residual_deviation, fit.quality.r_squared) +
         given + remark(found) + "\n";
}

std::string describe(const CalibratedModel& model, const DurationFactor& given) {
  double least = HUGE_VAL, largest = 0.;
  for (const CalibratedWave& wave : model.waves) {
    least = std::min(least, wave.peak_shear / wave.peak);
    largest = std::max(largest, wave.peak_shear / wave.peak);
  }
  std::string text = format("\n%s  scale %.4g, load %s, steps of %.3g s; peak F_T / peak P_I from %.2f to %.2f\n",
                            model.name.c_str(), model.scale, model.load.c_str(), model.step, least, largest);
  text += format("  %-8s %-5s %6s  %-16s %-16s %8s %8s %s\n", "measure", "r", "waves", "a", "b", "s", "R2",
                 format("with a = %.3g, b = %.3g: s, R2", given.a, given.b).c_str());
  for (const CalibrationFit& fit : model.fits) text += row(fit);
  return text;
}

std::string describe_waves(const Calibration& found) {
  std::string text =
      format("waves       %d of a grid of %d", static_cast<int>(found.n_waves), static_cast<int>(found.n_grid));
  for (const auto& [why, n] : found.left)
    text += std::string(why == found.left.begin()->first ? "; left out: " : ", ") + std::to_string(n) + " " + why;
  return text + "\n";
}

}  // namespace

std::string describe(const Design& design, const Calibration& found) {
  std::string text = design.tables.title.empty() ? "" : design.tables.title + "\n";
  text += describe_waves(found);
  for (const CalibratedModel& model : found.models) text += describe(model, found.given);
  return text + format("time        %.2f s\n", found.seconds);
}

std::string notes_and_warnings(const Calibration& found) {
  std::string text;
  for (const CalibratedModel& model : found.models) {
    const auto n = std::count_if(model.fits.begin(), model.fits.end(), [](const CalibrationFit& fit) {
      return !fit.fit || fit.fit->doubt != FitDoubt::none;
    });
    if (n > 0)
      text += "warning: model " + model.name + ": " + std::to_string(n) + " of " + std::to_string(model.fits.size()) +
              " fits do not tell a and b, see their remarks [not_identifiable]\n";
  }
  return text;
}

}  // namespace upbead
