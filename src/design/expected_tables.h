// The keys of the design file that `expected` alone needs.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "expected/dynamic_law.h"
#include "input/schema.h"
#include "upbead/expected/distribution.h"
#include "upbead/expected/life.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

/// [sea]: the record of sea states.
struct SeaTable {
  std::string states;                     ///< path of the CSV file
  double years = 1.;                      ///< that it covers
  std::optional<double> highest;          ///< cut of the heights, over H_1/3
  std::map<std::string, double> heights;  ///< whose waves are counted (m)
};

/// [storms]: in place of [sea]; angle in degrees.
struct StormsTable : StormClimate {
  std::optional<double> highest;  ///< cut of the heights, over H_1/3
};

/// [life]: Monte Carlo.
struct LifeTable {
  double years = 50.;
  int lives = 2000;
  int seed = 1;
  std::optional<Law> sliding;  ///< none: dynamic where there is a model, else exact
};

/// [scatter.NAME]: what is uncertain, by its name.
struct ScatterTables {
  std::optional<Scatter> significant_height, wave, period, force, uplift, friction, weight, water_level;
};

/// [dynamics]: the reduced model of the caisson.
struct DynamicsTable {
  std::string model;           ///< path of the file
  std::string load;            ///< its load that is the wave; "": the only or largest one
  std::optional<double> step;  ///< of the answers (s)
};

/// Which force the model answers.
enum class ImpactForce { impulse, goda_with_alpha_I };

/// [impact].
struct ImpactTable : ImpactAssumptions {
  ImpactForce force = ImpactForce::impulse;
};

/// The tables [sea], [storms], [life], [scatter.NAME], [dynamics], [impact] as written.
struct ExpectedTables {
  std::optional<SeaTable> sea;
  std::optional<StormsTable> storms;
  std::optional<LifeTable> life;
  ScatterTables scatter;
  std::optional<DynamicsTable> dynamics;
  ImpactTable impact;
};

struct DesignTables;
/// Declares those tables.
void add_expected_tables(TableSchema<DesignTables>& table);
TableSchema<StormsTable> storms_schema();

}  // namespace upbead
