// The keys of the case file, and the tables that they fill before a scene is made of them.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "case/load_table.h"
#include "case/records/record_keys.h"
#include "case/storm_cycles.h"
#include "input/schema.h"
#include "upbead/case/case.h"
#include "upbead/input/report_head.h"
#include "upbead/model/scene.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// The table [sliding.uplift] as written.
struct UpliftTable : UpliftChoice, HistoryKeys, GaugeKeys {};

/// The table [sliding] as written; `sliding` of Scene is made of it.
struct SlidingTable : SlidingChoice {
  std::optional<double> own_friction, own_submerged_weight;  ///< none: of [section], of the contact, or the default
  std::optional<UpliftTable> uplift_table;
};

/// The whole file as written; `loads`, `sliding` and `cycles` of Scene are made of load_tables, sliding_table and
/// cycles_table.
struct CaseTables : Scene {
  std::optional<CyclesTable> cycles_table;
  std::optional<SlidingTable> sliding_table;
  std::map<std::string, LoadTable> load_tables;
  std::optional<Section> section;
  std::optional<DurationFactor> duration;  ///< k(alpha*)
  std::optional<CombinedModel> combined;   ///< of S with a standing wave besides the pulse
  std::map<std::string, MeasuredKeys> measured;
  ReportHead report;
  AccuracyOf accuracy_of = AccuracyChoice().of;
  bool accuracy_estimate = AccuracyChoice().estimate;
};

/// The tables with every choice that the program made for what is left open, and with paths as seen from
/// `output_folder`.
CaseTables effective_tables(const Case& problem, const std::string& output_folder);

TableSchema<CaseTables> case_schema();
/// Those of `waves`, `expected`, `calibrate`, `reliability`, which a case passes over.
std::vector<std::string> tables_of_designs();
TableSchema<Fluid> fluid_schema();
TableSchema<Region> region_schema();
TableSchema<LoadTable> load_schema();
TableSchema<SlidingTable> sliding_schema();

}  // namespace upbead
