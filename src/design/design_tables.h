// The keys of the design file of `waves` and `expected`, and the tables that they fill.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "calibrate/calibration_tables.h"
#include "expected_tables.h"
#include "input/schema.h"
#include "sliding/elastic_block.h"
#include "upbead/sliding/combined.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// A table [waves.NAME] as written.
struct WaveTable {
  std::optional<double> height;              ///< H, or from deep_water_height by random breaking (m)
  std::optional<double> significant_height;  ///< H_1/3 (m); default H/1.8
  std::optional<double> deep_water_height;   ///< H_0' (m)
  double period = 0.;                        ///< T (s)
  double angle = 0.;                         ///< degrees, already turned towards the normal
  /// Measured or computed beforehand, in place of Goda's: peak P (N/m), F_T/P of it, and U at that instant (N/m).
  std::optional<double> force, shear_to_force_ratio, uplift;
  std::optional<double> pulse_duration;  ///< of that P as a triangle, for [ground] (s)
};

/// The whole file as written.
struct DesignTables : ExpectedTables {
  std::string title;
  double gravity = Water().gravity;  ///< top-level key; `water` takes it over once read (m/s2)
  Water water;
  Section section;
  DurationFactor duration;  ///< k(alpha*)
  CombinedModel combined;
  std::optional<ElasticBase> ground;
  std::map<std::string, WaveTable> waves;
  std::optional<CalibrationTable> calibration;
};

TableSchema<DesignTables> design_schema();

}  // namespace upbead
