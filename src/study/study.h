// The study file: keys of cases varied over lists, ranges or random samples.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "upbead/input/document.h"

namespace upbead {

/// Another value of one key of a case: its dotted path, and the value as TOML.
using Setting = std::pair<std::string, std::string>;

/// What runs of a study may take over from each other.
enum class StudyShare {
  all,    ///< each stage that is the same
  soils,  ///< and one model answers many soils, see soil_families.h
  none,   ///< nothing
};

/// One run of a study.
struct StudyRun {
  int case_index = 0;             ///< into Study::cases
  std::vector<Setting> varied;    ///< by Study::keys, in their order
  std::vector<Setting> settings;  ///< all that is set in the case: fixed, varied and following keys
  int point = 0;                  ///< of a Sobol sample: its base point
  std::string matrix = {};        ///< of a Sobol sample: "A", "B", or the key whose value is of B, the others of A
};

/// A study that has been read: its runs in their order, with all values.
struct Study {
  std::string title;
  std::string stem;                ///< name of the file without folder and ending
  std::vector<std::string> cases;  ///< paths as seen from the working folder
  std::vector<std::string> keys;   ///< the varied keys, in the order of the file
  std::vector<std::string> units;  ///< of the keys; "" where there is none
  std::vector<std::string> reads;  ///< paths into summary.json
  StudyShare share = StudyShare::all;
  bool summaries = false;  ///< whether the whole summary of each run is kept
  std::vector<StudyRun> runs;
  std::vector<InputFile> inputs;  ///< the study, its cases, all files that they name
  std::uint64_t fingerprint = 0;  ///< of the study, its cases, all files that they name, and the program's version
};

/// Texts KEY=VALUE in the form that read_case takes.
std::vector<std::string> overrides_of(const StudyRun& run);

/// Reads and checks a study with overrides KEY=VALUE. Also reads each case with the settings of its first run that
/// can be read: if none of the first 1,000 can, that is a mistake. Throws InputError with every mistake.
Study read_study(const std::string& path, const std::vector<std::string>& overrides = {});

/// Every key of the study file as Markdown.
std::string study_reference();

/// The same keys as JSON Schema (draft 4), with which editors complete and check a study file.
std::string study_json_schema();

}  // namespace upbead
