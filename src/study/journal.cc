#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "study/checks_in_runs.h"
#include "study/results.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

/// The folder of the summaries of a study's runs.
fs::path summary_folder(const std::string& output_folder) {
  return fs::path(output_folder) / "runs";
}

RunResult result_of(const Json& json) {
  RunResult result;
  result.done = json.at("done");
  for (const Json& value : json.at("values"))
    result.values.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
  result.message = json.at("message");
  result.doubts.checks = checks_from(json.value("checks", Json::array()));
  result.doubts.warnings = json.value("warnings", result.doubts.warnings);
  result.doubts.why_void = json.value("void", std::string());
  result.shared = static_cast<Shared>(json.at("shared").get<int>());
  result.why_own = json.value("why_own", std::string());
  if (json.contains("error_estimate")) result.error_estimate = json["error_estimate"].get<double>();
  result.seconds = json.at("seconds");
  return result;
}

Json to_object(int run, const RunResult& result) {
  Json json{{"run", run}, {"done", result.done}, {"values", Json::array()}};
  for (const std::optional<double>& value : result.values)
    json["values"].push_back(value ? Json(*value) : Json(nullptr));
  json["message"] = result.message;
  json["checks"] = to_json(result.doubts.checks);
  json["warnings"] = result.doubts.warnings;
  if (!result.doubts.why_void.empty()) json["void"] = result.doubts.why_void;
  json["shared"] = static_cast<int>(result.shared);
  if (!result.why_own.empty()) json["why_own"] = result.why_own;
  if (result.error_estimate) json["error_estimate"] = *result.error_estimate;
  json["seconds"] = result.seconds;
  return json;
}

}  // namespace

JournalsRead read_journals(const std::string& output_folder, const Study& study, const std::string& torn_of) {
  JournalsRead read{Results(study.runs.size())};
  const JournalsOf journals{output_folder, study.fingerprint,
                            "another study, or of this one before it, its cases or the program changed",
                            "add --restart to forget them, or choose another folder with --out DIR"};
  read.torn = read_lines(journals, torn_of, [&read](const Json& line) {
    if (line.contains("lost"))
      read.lost += line.at("lost").get<int>();
    else if (line.contains("run"))
      read.results.at(line.at("run").get<std::size_t>()) = result_of(line);
  });
  return read;
}

void remove_journals(const std::string& output_folder) {
  std::error_code code;
  const fs::path journals = journal_folder(output_folder);
  for (const auto& files : {files_in(journals, journal_ending), files_in(journals, ".h5"), files_in(journals, ".txt"),
                            files_in(journals, merged_ending), files_in(summary_folder(output_folder), ".json")})
    for (const fs::path& path : files)
      if (!fs::remove(path, code) && code)
        throw InputError({path.string()}, "cannot be removed: " + code.message(),
                         "choose another folder with --out DIR");
}

Journal::Journal(const std::string& output_folder, const Study& study, const std::string& name)
    : study_(study), output_folder_(output_folder), file_(output_folder, study.fingerprint, name) {
  std::error_code code;
  if (study.summaries) fs::create_directories(summary_folder(output_folder), code);
}

void Journal::add(int run, const RunResult& result) {
  if (study_.summaries && result.done)
    write_whole((summary_folder(output_folder_) / (std::to_string(run) + ".json")).string(), result.summary);
  file_.write(to_object(run, result));
}

void Journal::add_lost(int processes) {
  file_.write(Json{{"lost", processes}});
}

}  // namespace upbead
