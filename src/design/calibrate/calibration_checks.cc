#include "calibration_checks.h"

#include "../expected_checks.h"
#include "base/text.h"
#include "family.h"

namespace upbead {

namespace {

constexpr double most_waves = 1e6;  // of the grid: minutes

double n_grid(const CalibrationTable& grid) {
  double n = 1.;
  for (const NumberList* list :
       {&grid.relative_height, &grid.period, &grid.relative_berm_depth, &grid.relative_berm_width})
    n *= static_cast<double>(list->values.size());
  return n;
}

void check_models(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const auto& models = tables.calibration->models;
  if (models.empty() && report.sound("calibration.models"))
    report.add(
        document.place("calibration"), "[calibration] has no reduced model",
        "add a table [calibration.models.NAME] with model = the path of a reduced model, made by 'upbead reduce'");
  if (!report.sound("section") || !report.sound("gravity") || !report.sound("fluid")) return;
  for (const auto& [name, model] : models) {
    const std::string path = dotted("calibration.models", name);
    if (report.sound(path))
      check_model(path, model, scaled(tables.section, model.scale), tables.water, document, report);
  }
}

void check_grid(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const CalibrationTable& grid = *tables.calibration;
  if (grid.steepness[0] >= grid.steepness[1])
    report.add(document.place("calibration.steepness"), "no steepness lies between the two limits",
               "give the least steepness H/L first, then a larger one");
  else if (n_grid(grid) > most_waves)
    report.add(document.place("calibration"),
               "the grid has " + significant(n_grid(grid)) + " waves, more than " + significant(most_waves),
               "give fewer heights, periods or berms");
  else if (report.sound("section") && report.sound("gravity") && report.sound("fluid") &&
           make_family(tables).waves.empty())
    report.add(document.place("calibration"), "every wave of the grid is beyond the limits of the formulas",
               "give H/h up to 0.8, periods with H below 0.142 L tanh(kh) and H/L within steepness, and d up to h'");
}

}  // namespace

void check_calibration(const DesignTables& tables, const Document& document, Diagnostics& report) {
  check_impact(tables, document, report);
  if (!tables.calibration) {
    if (report.sound("calibration"))
      report.add(document.place("calibration"), "the table [calibration] is missing, which 'calibrate' needs",
                 "add [calibration] with period = [T, ...] (s), and [calibration.models.NAME]");
    return;
  }
  const bool sound = report.sound("calibration");
  check_models(tables, document, report);
  if (sound) check_grid(tables, document, report);
}

}  // namespace upbead
