#include "design/calibrate/calibration_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/format.h"
#include "base/text.h"
#include "output/result_file.h"
#include "upbead/base/error.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

std::string name_of(const std::optional<double>& ratio) {
  return ratio ? significant(*ratio, 4) : "all";
}

/// "0.30 +- 0.01"; without the error where there is no meaningful one.
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
      return "not identifiable: a and b cannot be distinguished";
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

/// Between which a and b the soils lie, each with its own fit.
std::string text_of_soils(const std::vector<CalibratedSoil>& soils) {
  std::vector<double> a, b;
  for (const CalibratedSoil& soil : soils)
    if (soil.fit) {
      a.push_back(soil.fit->best.a);
      b.push_back(soil.fit->best.b);
    }
  if (a.empty()) return "";
  const auto range = [](const std::vector<double>& list) { return std::minmax_element(list.begin(), list.end()); };
  return format("  soils       %d of %d with a fit of their own: a from %.4g to %.4g, b from %.4g to %.4g\n",
                static_cast<int>(a.size()), static_cast<int>(soils.size()), *range(a).first, *range(a).second,
                *range(b).first, *range(b).second);
}

std::string text_of(const CalibratedModel& model, const DurationFactor& given) {
  double least = HUGE_VAL, largest = 0.;
  for (const CalibratedWave& wave : model.waves) {
    least = std::min(least, wave.peak_shear / wave.impact.peak);
    largest = std::max(largest, wave.peak_shear / wave.impact.peak);
  }
  std::string text = format("\n%s  scale %.4g, load %s, steps of %.3g s; peak F_T / peak P_I from %.2f to %.2f\n",
                            model.name.c_str(), model.scale, model.load.c_str(), model.step, least, largest);
  text += format("  %-8s %-5s %6s  %-16s %-16s %8s %8s %s\n", "measure", "r", "waves", "a", "b", "s", "R2",
                 format("with a = %.3g, b = %.3g: s, R2", given.a, given.b).c_str());
  for (const CalibrationFit& fit : model.fits) text += row(fit);
  text += text_of_soils(model.soils);
  const CalibrationFit* take = recommended(model);
  if (!take) return text + "  for design  none: every fit of S itself is doubted\n";
  return text +
         format("  for design  a = %.4g, b = %.4g: tau_0 by S itself (exact), r %s; k scatters by %.2g about it\n",
                take->fit->best.a, take->fit->best.b, name_of(take->ratio).c_str(), take->fit->residual_deviation);
}

std::string waves_text(const Calibration& found) {
  std::string text =
      format("waves       %d of a grid of %d", static_cast<int>(found.n_waves), static_cast<int>(found.n_grid));
  for (const auto& [why, n] : found.left)
    text += std::string(why == found.left.begin()->first ? "; left out: " : ", ") + std::to_string(n) + " " + why;
  return text + "\n";
}

/// The value of a row; none where there is no tau_0.
using Value = std::optional<double>;

struct Column {
  std::string name, unit, description;
  std::function<Value(const CalibratedWave&, const WaveDuration&)> value;
};

Column of_wave(const std::string& name, const std::string& unit, const std::string& description,
               double CalibratedWave::*member) {
  return {name, unit, description,
          [member](const CalibratedWave& wave, const WaveDuration&) -> Value { return wave.*member; }};
}

Column of_impact(const std::string& name, const std::string& unit, const std::string& description,
                 double ImpactWave::*member) {
  return {name, unit, description,
          [member](const CalibratedWave& wave, const WaveDuration&) -> Value { return wave.impact.*member; }};
}

std::vector<Column> wave_columns() {
  using W = CalibratedWave;
  return {{"wave", "", "number of the wave in the family",
           [](const W& wave, const WaveDuration&) -> Value { return static_cast<double>(wave.wave); }},
          of_wave("height", "m", "H", &W::height),
          of_wave("period", "s", "T", &W::period),
          of_wave("wavelength", "m", "L", &W::wavelength),
          of_wave("berm_depth", "m", "d", &W::berm_depth),
          of_wave("berm_width", "m", "B_M", &W::berm_width),
          of_wave("alpha_I", "", "impulsive pressure coefficient, negative or not", &W::alpha_I),
          of_wave("alpha_star", "", "max(alpha_2, alpha_I), at least 0", &W::alpha_star),
          of_wave("tau_0F", "s", "eq. (11)", &W::tau_0F),
          of_impact("standing_force", "N/m", "P_1", &ImpactWave::standing_force),
          of_impact("peak_force", "N/m", "P_I, peak of the impulsive force", &ImpactWave::peak),
          of_impact("rise", "s", "t_r", &ImpactWave::rise),
          of_impact("duration", "s", "t_d", &ImpactWave::duration),
          of_impact("reduction", "", "gamma of the standing part", &ImpactWave::reduction),
          of_impact("uplift", "N/m", "U_max", &ImpactWave::uplift),
          of_wave("peak_shear", "N/m", "largest F_T", &W::peak_shear),
          of_wave("peak_sliding_force", "N/m", "F_Smax, largest F_T + mu U", &W::peak_sliding_force)};
}

std::vector<Column> columns() {
  std::vector<Column> list = wave_columns();
  list.push_back({"ratio", "", "r = F_Smax/(mu W')",
                  [](const CalibratedWave&, const WaveDuration& duration) -> Value { return duration.ratio; }});
  list.push_back({"sliding", "m", "S of the history at that r",
                  [](const CalibratedWave&, const WaveDuration& duration) -> Value { return duration.sliding; }});
  for (const DurationMeasure measure : all_measures) {
    const auto tau_0 = [measure](const CalibratedWave&, const WaveDuration& duration) -> Value {
      const auto found = duration.tau_0.find(measure);
      return found == duration.tau_0.end() ? Value() : Value(found->second);
    };
    const std::string name = word(measure);
    list.push_back({"tau_0_" + name, "s", "tau_0 by the measure '" + name + "'; 0 where there is none", tau_0});
    list.push_back({"k_" + name, "", "tau_0/tau_0F by that measure; 0 where there is none",
                    [tau_0](const CalibratedWave& wave, const WaveDuration& duration) -> Value {
                      const Value found = tau_0(wave, duration);
                      return found ? Value(*found / wave.tau_0F) : Value();
                    }});
  }
  return list;
}

template <class Visitor>
void for_each_row(const Calibration& found, Visitor visit) {
  for (const CalibratedModel& model : found.models)
    for (const CalibratedWave& wave : model.waves)
      for (const WaveDuration& duration : wave.durations) visit(model, wave, duration);
}

std::string cell(const Column& column, const Value& value) {
  if (!value) return "";
  if (!std::isfinite(*value)) throw NumericsError("'" + column.name + "' is not finite; nothing was written");
  return number_text(*value);
}

}  // namespace

std::string text_of(const Design& design, const Calibration& found) {
  std::string text = design.tables.title.empty() ? "" : design.tables.title + "\n";
  text += waves_text(found);
  for (const CalibratedModel& model : found.models) text += text_of(model, found.given);
  return text + format("time        %.2f s\n", found.seconds);
}

NumberedWarnings warnings_of(const Design& design, const Calibration& found) {
  NumberedWarnings list = design.implausible;
  for (const CalibratedModel& model : found.models) {
    const auto n = std::count_if(model.fits.begin(), model.fits.end(), [](const CalibrationFit& fit) {
      return !fit.fit || fit.fit->doubt != FitDoubt::none;
    });
    if (n > 0)
      list.push_back({"not_identifiable", static_cast<double>(n), 0., "1",
                      "model " + model.name + ": " + std::to_string(n) + " of " + std::to_string(model.fits.size()) +
                          " fits do not tell a and b",
                      "see the remarks of the fits, and take a and b from the others"});
  }
  return list;
}

std::string calibration_csv(const Calibration& found) {
  const std::vector<Column> list = columns();
  std::string text = "model";
  for (const Column& column : list) text += "," + column.name;
  text += "\n";
  for_each_row(found, [&](const CalibratedModel& model, const CalibratedWave& wave, const WaveDuration& duration) {
    text += csv_cell(model.name);
    for (const Column& column : list) text += "," + cell(column, column.value(wave, duration));
    text += "\n";
  });
  return text;
}

std::string calibration_file(const Design& design, const Calibration& found) {
  std::vector<TableColumn> out{{"model", "", "", {}, {}}};
  for_each_row(found, [&](const CalibratedModel& model, const CalibratedWave&, const WaveDuration&) {
    out.front().texts.push_back(model.name);
  });
  for (const Column& column : columns()) {
    TableColumn& dataset = out.emplace_back(TableColumn{column.name, column.unit, column.description, {}, {}});
    for_each_row(found, [&](const CalibratedModel&, const CalibratedWave& wave, const WaveDuration& duration) {
      dataset.numbers.push_back(column.value(wave, duration).value_or(0.));
    });
  }
  return table_file(design.tables.title, out);
}

}  // namespace upbead
