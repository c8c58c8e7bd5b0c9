#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <tuple>

#include "study/results.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* ending = ".jsonl";

/// The folder of a study's journals.
fs::path journal_folder(const std::string& output_folder) {
  return fs::path(output_folder) / "journal";
}

std::vector<fs::path> journals_in(const fs::path& folder) {
  std::vector<fs::path> list;
  std::error_code code;  // where there is no folder there is no journal
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
    if (entry->path().extension() == ending) list.push_back(entry->path());
  std::sort(list.begin(), list.end());
  return list;
}

/// A line as JSON; null where it was cut off.
Json parsed(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  return json.is_object() ? json : Json(nullptr);
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
  json["seconds"] = result.seconds;
  return json;
}

void read_journal(const fs::path& path, std::uint64_t fingerprint, Results& results) {
  std::ifstream stream(path);
  std::string line;
  if (!std::getline(stream, line) || parsed(line).is_null()) return;  // the process was killed before its first run
  if (parsed(line).value("study", std::uint64_t{0}) != fingerprint)
    throw InputError({path.parent_path().parent_path().string()},
                     "the results there are of another study, or of this one before it, its cases or the program "
                     "changed",
                     "add --restart to forget them, or choose another folder with --out DIR");
  while (std::getline(stream, line)) {
    const Json json = parsed(line);
    if (!json.is_null()) results.at(json.at("run").get<std::size_t>()) = result_of(json);
  }
}

/// What runs can share: those with equal `mesh` share a mesh, those with equal `solved` a solution.
struct Likeness {
  int case_index;
  std::vector<Setting> mesh, solved;
  int run;

  bool operator<(const Likeness& other) const {
    return std::tie(case_index, mesh, solved, run) < std::tie(other.case_index, other.mesh, other.solved, other.run);
  }
};

Likeness likeness_of(const StudyRun& run, int number) {
  Likeness likeness{run.case_index, {}, {}, number};
  for (const Setting& setting : run.settings) {
    if (setting.first.rfind("mesh", 0) == 0)
      likeness.mesh.push_back(setting);
    else if (setting.first.rfind("sliding", 0) != 0)
      likeness.solved.push_back(setting);
  }
  return likeness;
}

}  // namespace

Results read_journals(const std::string& output_folder, std::uint64_t fingerprint, std::size_t n_runs) {
  Results results(n_runs);
  for (const fs::path& path : journals_in(journal_folder(output_folder))) read_journal(path, fingerprint, results);
  return results;
}

void remove_journals(const std::string& output_folder) {
  std::error_code code;
  for (const fs::path& path : journals_in(journal_folder(output_folder)))
    if (!fs::remove(path, code) && code)
      throw InputError({path.string()}, "cannot be removed: " + code.message(), "choose another folder with --out DIR");
}

Journal::Journal(const std::string& output_folder, std::uint64_t fingerprint, int rank) {
  const fs::path folder = journal_folder(output_folder);
  std::error_code code;
  fs::create_directories(folder, code);
  int session = 0;
  const auto name = [&] { return folder / (std::to_string(session) + "-" + std::to_string(rank) + ending); };
  while (fs::exists(name(), code)) ++session;
  path_ = name().string();
  stream_.open(path_);
  write(Json{{"study", fingerprint}}.dump());
}

void Journal::add(int run, const RunResult& result) {
  write(to_object(run, result).dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Journal::write(const std::string& line) {
  stream_ << line << std::endl;
  if (!stream_)
    throw InputError({path_}, "cannot be written", "make room on the disk, or choose another folder with --out DIR");
}

std::vector<std::vector<int>> schedule(const Study& study, const Results& results) {
  std::vector<Likeness> places;
  for (std::size_t i = 0; i < study.runs.size(); ++i)
    if (!results[i]) places.push_back(likeness_of(study.runs[i], static_cast<int>(i)));
  std::sort(places.begin(), places.end());
  std::vector<std::vector<int>> pieces;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool alike = i > 0 && std::tie(places[i].case_index, places[i].mesh, places[i].solved) ==
                                    std::tie(places[i - 1].case_index, places[i - 1].mesh, places[i - 1].solved);
    if (!alike) pieces.emplace_back();
    pieces.back().push_back(places[i].run);
  }
  return pieces;
}

}  // namespace upbead
