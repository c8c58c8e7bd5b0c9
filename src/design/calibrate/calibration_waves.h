// The waves of a calibration, and its breakwater at the size of a model.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "design/design_tables.h"
#include "expected/dynamic_law.h"

namespace upbead {

/// A wave and the mound that it meets.
struct CalibrationWave {
  double height = 0., period = 0., wavelength = 0.;  ///< H (m), T (s), L (m)
  double berm_depth = 0., berm_width = 0.;           ///< d, B_M (m)
  double alpha_I = 0., alpha_star = 0.;
};

struct CalibrationWaves {
  std::vector<CalibrationWave> waves;       ///< at the size of [section]
  std::size_t n_grid = 0;                   ///< number of waves in the whole grid
  std::map<std::string, std::size_t> left;  ///< number of waves left out, by reason; each counts once
};

/// The grid of [calibration], without what is beyond the formulas: H/h above 0.8 and waves above Miche's limit as in
/// `waves` (validity.h), waves too long for it (long_period), steepness outside the limits, berms below the caisson's
/// bottom or the bed.
CalibrationWaves calibration_waves(const DesignTables& tables);

/// The section with lengths times `scale` and weights times its square.
Section scaled(const Section& section, double scale);
/// The same for a wave, with times multiplied by the root of `scale`.
CalibrationWave scaled(CalibrationWave wave, double scale);

/// The section with the mound of a wave; both are at the same size.
Section with_mound(Section section, const CalibrationWave& wave);

/// A sea state with H_1/3 = H/1.8, which determines where h_b is taken.
SeaState sea_state(const CalibrationWave& wave);

}  // namespace upbead
