// A source of loads: a way to give a table [loads.NAME] its course in time. Each is a file, and a row of load_ways()
// (load_table.h).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "case/records/record_layout.h"
#include "case/time_end.h"
#include "input/schema.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/case/case.h"
#include "upbead/model/gauges.h"
#include "upbead/model/load.h"

namespace upbead {

struct LoadTable;
struct LoadCheck;

/// What a source made of a table [loads.NAME], or of a prescribed uplift by a file.
struct LoadSource {
  std::string name;                  ///< "wall", "sliding.uplift"
  std::string title;                 ///< for people: "loads.wall", "sliding.uplift"
  Load load;                         ///< what its loads have in common, as written
  std::map<std::string, Load> made;  ///< loads for the scene, which takes them from here
  std::vector<InputFile> files;      ///< that it is read from
  RecordNotes notes;                 ///< how they were read
  std::optional<Action> action;      ///< none where it is switched off
  std::optional<Gauges> gauges;      ///< where it is a row of pressures
  NumberedWarnings warnings;

  virtual ~LoadSource() = default;
  bool acts() const { return load.factor != 0.; }
};

/// A table [loads.NAME] in which no mistake was found, and its case, whose scene has all but its loads and sliding. An
/// end that is left open is infinite.
struct GivenLoad {
  const Case& problem;
  std::string name, path;  ///< "wall", "loads.wall"
  const LoadTable& table;

  Place place(const std::string& key) const { return problem.place(path + "." + key); }
  double end() const { return problem.scene.time.end; }
};

/// A row: how a table tells that it gives its load in this way, and what is made of it.
struct LoadWay {
  bool (*gives)(const LoadTable& table);
  void (*declare)(TableSchema<LoadTable>& table);  ///< its keys
  void (*check)(const LoadCheck& check);           ///< looks for mistakes, without reading a file
  std::shared_ptr<LoadSource> (*read)(const GivenLoad& given);
  std::vector<std::string LoadTable::*> paths = {};  ///< keys that name files
  std::string needs = {};                            ///< another table that must have no mistake
};

/// The last way that fits the table; where it gives neither pulse nor anything else, by_history().
const LoadWay& way_of(const LoadTable& table);

/// Fills what all sources have of a load.
void begin(const GivenLoad& given, LoadSource& source);

/// A source of which no more is filled.
std::shared_ptr<LoadSource> begun(const GivenLoad& given);

/// The load with its factor in its history; without history where that is zero.
Load with_factor(Load load);

/// All sources of a case, by name, the uplift last.
std::vector<const LoadSource*> sources_of(const Case& input);

/// Those of one type.
template <class T>
std::vector<const T*> sources_of_type(const Case& input) {
  std::vector<const T*> list;
  for (const LoadSource* source : sources_of(input))
    if (const auto* one = dynamic_cast<const T*>(source)) list.push_back(one);
  return list;
}

}  // namespace upbead
