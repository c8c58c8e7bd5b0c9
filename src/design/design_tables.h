// The keys of the design file of `waves`, `expected` and `calibrate`, and the tables that they fill.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/formula_wave.h"
#include "design/reliability_table.h"
#include "expected/dynamic_law.h"
#include "input/schema.h"
#include "input/values.h"
#include "sliding/elastic_block.h"
#include "soils/soil_text.h"
#include "upbead/expected/distribution.h"
#include "upbead/expected/life.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/input/report_head.h"
#include "upbead/sliding/combined.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// `[0.2, 0.4, 0.8]`, or `{ from = 0.2, to = 0.8, n = 4 }` at equal distances.
struct NumberList {
  std::vector<double> values;
};

Diagnostics read_value(const Node& node, const KeyInfo& key, NumberList& value);
std::string type_text(const KeyInfo& key, const NumberList*);
inline ValueShape shape_of(const KeyInfo&, const NumberList*) {
  return ValueShape::list_or_table;
}
/// Prints the numbers, always as a list.
std::string print_value(const KeyInfo& key, const NumberList& value);
void visit_value(const KeyInfo& key, const std::string& path, NumberList& value, const NumberVisitor& visitor);

/// Which waves of a sea state are taken: those after Goda's random breaking, or all up to a cut.
struct HighestWave {
  bool breaking = true;
  double cut = RayleighHeights::no_cut;  ///< over H_1/3; higher waves are left out
};

Diagnostics read_value(const Node& node, const KeyInfo& key, HighestWave& value);
std::string type_text(const KeyInfo& key, const HighestWave*);
inline ValueShape shape_of(const KeyInfo&, const HighestWave*) {
  return ValueShape::anything;  // a number or a word
}
std::string print_value(const KeyInfo& key, const HighestWave& value);
inline void visit_value(const KeyInfo&, const std::string&, HighestWave&, const NumberVisitor&) {}

/// [sea]: the record of sea states.
struct SeaTable {
  std::string states;  ///< path of the CSV file
  double years = 1.;   ///< years covered by the record
  HighestWave highest;
  std::map<std::string, double> heights;  ///< by name: heights (m) above which waves are counted
};

/// [storms]: in place of [sea]; angle in degrees.
struct StormsTable : StormClimate {
  HighestWave highest;
};

/// [life]: Monte Carlo.
struct LifeTable {
  double years = 50.;
  int lives = 2000;
  int seed = 1;
  std::optional<Law> sliding;  ///< none: dynamic where there is a model, else exact
};

/// [scatter.NAME]: the uncertain quantities, by name.
struct ScatterTables {
  std::optional<Scatter> significant_height, wave, period, force, uplift, friction, weight, water_level;
};

/// [dynamics]: the reduced model of the caisson.
struct DynamicsTable {
  std::string model;           ///< path of the file
  std::string load;            ///< the load that stands for the wave; "": the only or largest one
  std::optional<double> step;  ///< of the samples (s)
  Soil soil;                   ///< of a model of soils; keys that are left out have the case's value
  int node_waves = 100;        ///< waves that are answered node by node, where the model has contact; 0: none
};

/// [impact].
struct ImpactTable : ImpactAssumptions {
  ImpactForce force = ImpactForce::impulse;
};

/// The tables [sea], [storms], [life], [scatter.NAME], [dynamics], [impact] as written.
struct ExpectedTables {
  /// The table of [sea] or of [storms], one of which is given.
  const HighestWave& highest() const { return sea ? sea->highest : storms->highest; }

  std::optional<SeaTable> sea;
  std::optional<StormsTable> storms;
  std::optional<LifeTable> life;
  ScatterTables scatter;
  std::optional<DynamicsTable> dynamics;
  ImpactTable impact;
};

/// [calibration.models.NAME].
struct ScaledModel : DynamicsTable {
  double scale = 1.;         ///< length of this model's breakwater over that of [section]
  std::optional<int> soils;  ///< of a model of soils: so many at random from its box, in place of one
};

/// [calibration]: a grid of waves and mounds, and the ratios r.
struct CalibrationTable {
  NumberList relative_height{{0.3, 0.4, 0.5, 0.6, 0.7, 0.8}};        ///< H/h
  NumberList period;                                                 ///< T (s)
  NumberList relative_berm_depth{{0.3, 0.35, 0.4, 0.45, 0.5, 0.6}};  ///< d/h
  NumberList relative_berm_width{{0.02, 0.06, 0.12, 0.2, 0.3}};      ///< B_M/L
  NumberList ratios{{1.05, 1.2, 1.5, 2.}};                           ///< r = F_Smax/(mu W')
  Pair steepness{0.005, 0.14};                                       ///< least and largest H/L
  std::map<std::string, ScaledModel> models;
};

/// A table [waves.NAME] as written.
struct WaveTable : WaveGiven {
  /// Measured or computed elsewhere, in place of Goda's: peak P (N/m), its ratio F_T/P, and U at the time of the peak
  /// (N/m).
  std::optional<double> force, shear_to_force_ratio, uplift;
  std::optional<double> pulse_duration;  ///< of that P, as a triangle, for [ground] (s)
};

/// The whole file as written.
struct DesignTables : ExpectedTables {
  std::string title;
  ReportHead report;
  double gravity = Water().gravity;  ///< top-level key; copied to `water` once it is read (m/s2)
  Water water;
  Section section;
  DurationFactor duration;  ///< k(alpha*)
  CombinedModel combined;
  std::optional<ElasticBase> ground;
  std::map<std::string, double> levels;  ///< of `waves`, above the section's still water, by name (m)
  std::map<std::string, WaveTable> waves;
  std::optional<CalibrationTable> calibration;
  Limits limits;  ///< of `expected` and `waves`
  std::optional<ReliabilityTable> reliability;
};

TableSchema<DesignTables> design_schema();
/// Declares the tables of `expected`.
void add_expected_tables(TableSchema<DesignTables>& table);
TableSchema<CalibrationTable> calibration_schema();

}  // namespace upbead
