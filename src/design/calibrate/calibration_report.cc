#include "design/calibrate/calibration_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "output/output_text.h"
#include "output/result_file.h"
#include "upbead/base/error.h"
#include "upbead/input/node.h"
#include "waves/section_warnings.h"

namespace upbead {

namespace {

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

std::string brief(const Json& summary) {
  const std::vector<OutputRow> rows = rows_of_calibration();
  std::string text = summary["title"].get<std::string>();
  text += (text.empty() ? "" : "\n") + text_of(summary, rows, {"waves"});
  for (const auto& model : summary["models"].items()) {
    Json some;
    for (const char* key : {"load", "scale", "step", "recommended", "soils"})
      some["models"][model.key()][key] = model.value()[key];
    if (model.value()["recommended"].is_null()) text += "\n" + model.key() + ": every fit of S itself is doubted";
    text += "\n" + text_of(some, rows) +
            table_of(model.value()["fits"], rows, "models.NAME.fits[]",
                     {{"measure", "measure"},
                      {"r", "ratio"},
                      {"waves", "points"},
                      {"a", "a"},
                      {"+-", "standard_error.a"},
                      {"b", "b"},
                      {"+-", "standard_error.b"},
                      {"s", "residual_deviation"},
                      {"R2", "quality.r_squared"},
                      {"given: s", "given.deviation"},
                      {"R2", "given.r_squared"},
                      {"doubt", "doubt"}});
  }
  return text;
}

NumberedWarnings warnings_of(const Design& design, const Calibration& found) {
  NumberedWarnings list = design.implausible;
  append(list, section_warnings(design.tables.section, design.tables.water));
  for (const CalibratedModel& model : found.models) {
    for (NumberedWarning warning : model.warnings) {
      warning.what = "model " + model.name + ": " + warning.what;
      list.push_back(std::move(warning));
    }
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
