#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "case/input_files.h"
#include "study/results.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* ending = ".jsonl";

/// The folder of the summaries of a study's runs.
fs::path summary_folder(const std::string& output_folder) {
  return fs::path(output_folder) / "runs";
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& with_ending) {
  std::vector<fs::path> list;
  std::error_code code;  // where there is no folder there is no file
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
    if (entry->path().extension() == with_ending) list.push_back(entry->path());
  std::sort(list.begin(), list.end());
  return list;
}

/// Of a line without its check, of the journal of one study: a line that is torn, or made of two, has another one.
std::string check_of(const Json& json, std::uint64_t study) {
  Fingerprint fingerprint;
  fingerprint.add(std::to_string(study));
  fingerprint.add(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  return std::to_string(fingerprint.value());
}

std::string line_of(Json json, std::uint64_t study) {
  json["check"] = check_of(json, study);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Whether the line, parsed to `json`, is one of a study to the last byte.
bool is_whole(const std::string& line, Json json, std::uint64_t study) {
  if (!json.is_object() || json.erase("check") == 0) return false;
  return line_of(json, study) == line + "\n";
}

RunResult result_of(const Json& json) {
  RunResult result;
  result.done = json.at("done");
  for (const Json& value : json.at("values"))
    result.values.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
  result.message = json.at("message");
  result.doubts.failing = json.value("failing", result.doubts.failing);
  result.doubts.warnings = json.value("warnings", result.doubts.warnings);
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
  json["failing"] = result.doubts.failing;
  json["warnings"] = result.doubts.warnings;
  json["shared"] = static_cast<int>(result.shared);
  if (!result.why_own.empty()) json["why_own"] = result.why_own;
  if (result.error_estimate) json["error_estimate"] = *result.error_estimate;
  json["seconds"] = result.seconds;
  return json;
}

/// Whether the line begins the journal of another study, whole; `is_old`: of a program whose lines had no check.
bool begins_another(const std::string& line, const Json& json, std::uint64_t study, bool is_old) {
  if (!json.is_object() || !json.contains("study") || !json["study"].is_number_unsigned()) return false;
  const auto other = json["study"].get<std::uint64_t>();
  return other != study && (is_old || is_whole(line, json, other));
}

/// `counts`: lines that are not whole.
void read_journal(const fs::path& path, std::uint64_t fingerprint, bool counts, JournalsRead& read) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const bool is_old = text.find("\"check\"") == std::string::npos;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const Json json = Json::parse(line, nullptr, false);
    if (begins_another(line, json, fingerprint, is_old))
      throw InputError({path.parent_path().parent_path().string()},
                       "the results there are of another study, or of this one before it, its cases or the program "
                       "changed",
                       "add --restart to forget them, or choose another folder with --out DIR");
    if (!is_whole(line, json, fingerprint))
      read.torn += counts ? 1 : 0;
    else if (json.contains("lost"))
      read.lost += json.at("lost").get<int>();
    else if (json.contains("run"))
      read.results.at(json.at("run").get<std::size_t>()) = result_of(json);
  }
}

[[noreturn]] void cannot_write(const fs::path& path) {
  throw InputError({path.string()}, "cannot be written",
                   "make room on the disk, or choose another folder with --out DIR");
}

}  // namespace

fs::path journal_folder(const std::string& output_folder) {
  return fs::path(output_folder) / "journal";
}

JournalsRead read_journals(const std::string& output_folder, const Study& study, const std::string& torn_of) {
  JournalsRead read{Results(study.runs.size())};
  for (const fs::path& path : files_in(journal_folder(output_folder), ending))
    read_journal(path, study.fingerprint, path.filename().string().find(torn_of) != std::string::npos, read);
  return read;
}

void remove_journals(const std::string& output_folder) {
  std::error_code code;
  const fs::path journals = journal_folder(output_folder);
  for (const auto& files : {files_in(journals, ending), files_in(journals, ".h5"), files_in(journals, ".txt"),
                            files_in(journals, merged_ending), files_in(summary_folder(output_folder), ".json")})
    for (const fs::path& path : files)
      if (!fs::remove(path, code) && code)
        throw InputError({path.string()}, "cannot be removed: " + code.message(),
                         "choose another folder with --out DIR");
}

Journal::Journal(const std::string& output_folder, const Study& study, const std::string& name)
    : study_(study), output_folder_(output_folder) {
  std::error_code code;
  fs::create_directories(journal_folder(output_folder), code);
  if (study.summaries) fs::create_directories(summary_folder(output_folder), code);
  for (int session = 0; descriptor_ < 0; ++session) {
    path_ = (journal_folder(output_folder) / (std::to_string(session) + "-" + name + ending)).string();
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) cannot_write(path_);
  }
  write(line_of(Json{{"study", study.fingerprint}}, study.fingerprint));
}

Journal::~Journal() {
  if (descriptor_ >= 0) close(descriptor_);
}

void Journal::add(int run, const RunResult& result) {
  if (study_.summaries && result.done)
    write_whole((summary_folder(output_folder_) / (std::to_string(run) + ".json")).string(), result.summary);
  write(line_of(to_object(run, result), study_.fingerprint));
}

void Journal::add_lost(int processes) {
  write(line_of(Json{{"lost", processes}}, study_.fingerprint));
}

void Journal::write(const std::string& line) {
  std::size_t written = 0;
  do {
    const ssize_t n = descriptor_ < 0 ? -1 : ::write(descriptor_, line.data() + written, line.size() - written);
    if (n < 0) cannot_write(path_);
    written += static_cast<std::size_t>(n);
  } while (written < line.size());
}

}  // namespace upbead
