// The calibration of k(alpha*): tau_0 of many waves by the caisson's own dynamics, the k fitted to them, and the
// output of `upbead calibrate`: summary.json, calibration.csv, results.h5, and in brief.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "design/calibrate/calibration_waves.h"
#include "design/design.h"
#include "expected/k_fit.h"
#include "output/output_schema.h"
#include "soils/soil_text.h"
#include "upbead/base/numbered_warning.h"

namespace upbead {

/// Ways to find tau_0 of a history, see HistoryDuration.
enum class DurationMeasure { paper, exact, excess, impulse };
inline constexpr std::array<DurationMeasure, 4> all_measures{DurationMeasure::paper, DurationMeasure::exact,
                                                             DurationMeasure::excess, DurationMeasure::impulse};
/// The word for it in files.
const char* word(DurationMeasure measure);

/// tau_0 of one history at one r.
struct WaveDuration {
  double ratio = 0.;                        ///< r
  double sliding = 0.;                      ///< S under this history with the resistance F_Smax/r (m)
  std::map<DurationMeasure, double> tau_0;  ///< s; absent where the caisson does not slide landward
};

/// One wave on one model, at the model's size.
struct CalibratedWave : CalibrationWave {
  std::size_t wave = 0;  ///< its number in the family
  double tau_0F = 0.;    ///< s
  ImpactWave impact;
  double peak_shear = 0., peak_sliding_force = 0.;  ///< largest F_T, F_Smax (N/m)
  std::vector<WaveDuration> durations;              ///< by r
};

/// A fit of k over the waves of one model.
struct CalibrationFit {
  DurationMeasure measure = DurationMeasure::exact;
  std::optional<double> ratio;  ///< r; none: all r together
  std::vector<DurationPoint> points;
  std::optional<DurationFit> fit;  ///< none where the points are too few
  FitQuality given;                ///< of the design's own a and b, by default those of the paper
  bool given_in_ellipse = false;
};

/// The recommended fit to the waves of one soil.
struct CalibratedSoil {
  Soil soil;
  double error = 0.;  ///< of the model's F_T, of its peak
  std::optional<DurationFit> fit;
};

struct CalibratedModel {
  std::string name, title, load;
  std::vector<CalibratedSoil> soils;  ///< of a model of soils whose waves are all in the fits
  double scale = 1.;
  double step = 0., shortest_rise = 0.;  ///< s
  std::vector<CalibratedWave> waves;
  std::vector<CalibrationFit> fits;
  NumberedWarnings warnings;  ///< of the scene of the model
};

/// The fit to take for design: by S itself (`exact`), at all r together, as one k serves all r. Where that fit is
/// doubtful, the fit by `exact` with the least residual among those that are not. Null where all are doubtful.
const CalibrationFit* recommended(const CalibratedModel& model);

struct Calibration {
  std::size_t n_grid = 0, n_waves = 0;
  std::map<std::string, std::size_t> left;  ///< number of waves left out, by reason
  DurationFactor given;                     ///< [duration]
  std::vector<CalibratedModel> models;
  double seconds = 0.;
};

/// For a design without mistakes, on all cores; the numbers do not depend on how many. Throws NumericsError where a
/// number is not finite.
Calibration calibrate(const Design& design);

/// Throws NumericsError where a number is not finite.
Json to_json(const Design& design, const Calibration& found);
/// The keys of that JSON.
std::vector<OutputRow> rows_of_calibration();
/// One row for each model, wave and r.
std::string calibration_csv(const Calibration& found);
/// The same columns as the bytes of an HDF5 file.
std::string calibration_file(const Design& design, const Calibration& found);
/// The recommended fits and all others, for the terminal.
std::string brief(const Json& summary);
/// Numbers whose unit was probably mistaken, and fits that are doubtful.
NumberedWarnings warnings_of(const Design& design, const Calibration& found);

}  // namespace upbead
