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

/// One run of a study.
struct StudyRun {
  int case_index = 0;             ///< into Study::cases
  std::vector<Setting> varied;    ///< by Study::keys, in their order
  std::vector<Setting> settings;  ///< all that is set in the case: what is fixed, varied, and follows
};

/// A study that has been read: its runs in their order, fully determined.
struct Study {
  std::string title;
  std::string stem;                ///< the file's name without folder and ending
  std::vector<std::string> cases;  ///< paths as seen from the working folder
  std::vector<std::string> keys;   ///< what is varied, in the order of the file
  std::vector<std::string> units;  ///< of the keys; "" where there is none
  std::vector<std::string> reads;  ///< paths into summary.json
  std::vector<StudyRun> runs;
  std::vector<InputFile> inputs;  ///< the study, its cases, all files that they name
  std::uint64_t fingerprint = 0;  ///< of the study, its cases, all files that they name, and the program's version
};

/// Texts KEY=VALUE as read_case takes them.
std::vector<std::string> overrides_of(const StudyRun& run);

/// Reads and checks a study with overrides KEY=VALUE. Also reads its cases with the first settings that fit them:
/// where none of the first 1,000 do, that is a mistake. Throws InputError with every mistake.
Study read_study(const std::string& path, const std::vector<std::string>& overrides = {});

/// Every key of the study file as Markdown.
std::string study_reference();

/// The same keys as JSON Schema (draft 4): editors complete and check a study file by it.
std::string study_json_schema();

}  // namespace upbead
