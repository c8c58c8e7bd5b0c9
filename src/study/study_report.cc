// study.csv, study.h5, summary.json, and text for the terminal.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text.h"
#include "base/version.h"
#include "output/result_file.h"
#include "output/versions.h"
#include "study/checks_in_runs.h"
#include "study/results.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t n_listed = 10;  // failures shown on the terminal

/// The command that repeats a run alone.
std::string command_of(const Study& study, const StudyRun& run) {
  std::string text = "upbead run " + study.cases[static_cast<std::size_t>(run.case_index)];
  for (const std::string& setting : overrides_of(run)) text += " --set '" + setting + "'";
  return text;
}

template <class Visitor>
void for_each_failure(const Study& study, const Results& results, Visitor visit) {
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i] && !results[i]->done) visit(i, study.runs[i], results[i]->message);
}

int count(const Results& results, Shared shared) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), [shared](const auto& result) {
    return result && result->done && result->shared == shared;
  }));
}

double longest(const Results& results) {
  double seconds = 0.;
  for (const auto& result : results) seconds = std::max(seconds, result ? result->seconds : 0.);
  return seconds;
}

Json failures(const Study& study, const Results& results) {
  Json list = Json::array();
  for_each_failure(study, results, [&](std::size_t i, const StudyRun& run, const std::string& message) {
    Json settings = Json::object();
    for (const auto& [key, value] : run.settings) settings[key] = value;
    list.push_back({{"run", i}, {"message", message}, {"settings", settings}, {"command", command_of(study, run)}});
  });
  return list;
}

Json skipped(const Results& results) {
  Json list = Json::array();
  const auto add = [&list](int n, const std::string& what, const std::string& why) {
    if (n > 0) list.push_back({{"what", what + " of " + std::to_string(n) + " runs"}, {"why", why}});
  };
  add(count(results, Shared::mesh), "mesh", "the run before had the same");
  add(count(results, Shared::system), "mesh and equations",
      "the run before differed in the course of its loads, in times, scheme, tolerance, output or what is told");
  add(count(results, Shared::basis), "mesh, equations and basis",
      "the run before had loads of the same shortest duration, too");
  add(count(results, Shared::solution), "mesh and solution", "the run before differed in what is only told");
  add(count(results, Shared::soils), "equations of their own",
      "one model answers all soils, each within its error_estimate");
  return list;
}

/// Why runs were solved by themselves though other soils have one model: each reason, and how many runs.
std::map<std::string, int> reasons_of_own(const Results& results) {
  std::map<std::string, int> reasons;
  for (const auto& result : results)
    if (result && !result->why_own.empty()) ++reasons[result->why_own];
  return reasons;
}

/// Runs of which no verdict may be drawn, by the warnings that say so.
std::map<std::string, std::vector<int>> void_runs(const Results& results) {
  std::map<std::string, std::vector<int>> runs;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i] && !results[i]->doubts.why_void.empty())
      runs[results[i]->doubts.why_void].push_back(static_cast<int>(i));
  return runs;
}

/// A warning of several runs, as the first of them tells it.
struct InRuns {
  std::string name, text;
  int runs = 0;
  std::size_t first = 0;
};

/// Each name once, the most frequent first.
std::vector<InRuns> warnings_in_runs(const Results& results) {
  std::vector<InRuns> list;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i]) continue;
    std::set<std::string> of_run;
    for (const auto& [name, text] : results[i]->doubts.warnings) {
      if (!of_run.insert(name).second) continue;
      const auto known =
          std::find_if(list.begin(), list.end(), [&](const InRuns& found) { return found.name == name; });
      if (known == list.end())
        list.push_back({name, text, 1, i});
      else
        ++known->runs;
    }
  }
  std::stable_sort(list.begin(), list.end(), [](const InRuns& a, const InRuns& b) { return a.runs > b.runs; });
  return list;
}

/// Whether no two runs have one value of that key, as of a draw.
bool is_always_new(const Study& study, std::size_t key) {
  std::set<std::string> values;
  return std::all_of(study.runs.begin(), study.runs.end(),
                     [&](const StudyRun& run) { return values.insert(run.varied[key].second).second; });
}

/// Whether every number that is read is there in some run and not 0: one that never is may have its reason.
bool all_tell(const Study& study, const Results& results) {
  for (std::size_t read = 0; read < study.reads.size(); ++read)
    if (std::none_of(results.begin(), results.end(),
                     [&](const auto& r) { return r && r->done && r->values[read].value_or(0.) != 0.; }))
      return false;
  return true;
}

/// Whether runs that differ in nothing but one key, by which two of them differ, have the same numbers and checks.
bool is_unfelt(const Study& study, const Results& results, std::size_t key) {
  std::map<std::vector<std::string>, std::size_t> first;  // run by its case and its other values
  bool compared = false;
  for (std::size_t k = 0; k < study.keys.size(); ++k)
    if (k != key && is_always_new(study, k)) return false;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i] || !results[i]->done) continue;
    std::vector<std::string> rest{std::to_string(study.runs[i].case_index)};
    for (std::size_t k = 0; k < study.keys.size(); ++k)
      if (k != key) rest.push_back(study.runs[i].varied[k].second);
    const auto [other, is_new] = first.emplace(std::move(rest), i);
    if (is_new || study.runs[other->second].varied[key].second == study.runs[i].varied[key].second) continue;
    if (results[i]->values != results[other->second]->values ||
        to_json(results[i]->doubts.checks) != to_json(results[other->second]->doubts.checks))
      return false;
    compared = true;
  }
  return compared;
}

/// Warnings of the runs, and varied_unfelt: keys that change no number that is read, as those of a part that the case
/// does not use.
std::vector<InRuns> all_warnings(const Study& study, const Results& results) {
  std::vector<InRuns> list = warnings_in_runs(results);
  if (!all_tell(study, results)) return list;
  for (std::size_t k = 0; k < study.keys.size(); ++k)
    if (is_unfelt(study, results, k))
      list.push_back({"varied_unfelt",
                      "'" + study.keys[k] +
                          "' is varied, and no number that is read, nor any check, changes with it; look whether the "
                          "case uses that key, and read a number that depends on it",
                      n_results(results), 0});
  return list;
}

Json to_json(const std::vector<InRuns>& found) {
  Json list = Json::array();
  for (const InRuns& one : found)
    list.push_back({{"name", one.name}, {"runs", one.runs}, {"first_run", one.first}, {"text", one.text}});
  return list;
}

/// "name, name" of one run, each once.
std::string names_of(const std::vector<std::pair<std::string, std::string>>& findings) {
  std::vector<std::string> names;
  for (const auto& [name, text] : findings)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return join(names, "; ");
}

std::string in_words(const std::vector<InRuns>& found, std::size_t of) {
  std::string text;
  for (const InRuns& one : found)
    text += "warning     " + one.name + ": in " + std::to_string(one.runs) + " of " + std::to_string(of) +
            " runs, first in run " + std::to_string(one.first) + ": " + one.text + "\n";
  return text;
}

/// "3, 5, 8 and 2 more".
std::string listed(const std::vector<int>& runs) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(runs.size(), n_listed); ++i) words.push_back(std::to_string(runs[i]));
  return join(words, ", ") + (runs.size() > n_listed ? " and " + std::to_string(runs.size() - n_listed) + " more" : "");
}

std::string in_words(const std::vector<MissingRuns>& missing) {
  std::string text;
  std::size_t n = 0;
  for (const MissingRuns& of : missing) {
    if (n++ == n_listed) break;
    text += "missing     " + (of.part.empty() ? "" : "part " + of.part + ": ") + std::to_string(of.runs.size()) +
            " runs (" + listed(of.runs) + ")" + (of.holder.empty() ? "" : ", at which " + of.holder + " works") +
            "\n            " + of.command + "\n";
  }
  if (missing.size() > n_listed)
    text +=
        "            and " + std::to_string(missing.size() - n_listed) + " more parts, see missing in summary.json\n";
  return text;
}

/// A word without the quotes that TOML gives it.
std::string plain(const std::string& toml) {
  return toml.size() > 1 && toml.front() == '"' ? toml.substr(1, toml.size() - 2) : toml;
}

bool is_number(const std::string& toml, double& number) {
  char* end = nullptr;
  number = std::strtod(toml.c_str(), &end);
  return !toml.empty() && *end == '\0';
}

const std::string& case_of(const Study& study, const StudyRun& run) {
  return study.cases[static_cast<std::size_t>(run.case_index)];
}

/// Whether runs belong to the matrices of a Sobol sample.
bool has_matrices(const Study& study) {
  return !study.runs.empty() && !study.runs.front().matrix.empty();
}

void add_matrices(const Study& study, std::vector<TableColumn>& columns) {
  TableColumn point{"runs/point", "", "number of the point of the Sobol sample", {}, {}};
  TableColumn matrix{"runs/matrix", "", "", {}, {}};
  for (const StudyRun& run : study.runs) {
    point.numbers.push_back(run.point);
    matrix.texts.push_back(run.matrix);
  }
  columns.push_back(point);
  columns.push_back(matrix);
}

/// The values of one varied key in all runs.
TableColumn varied_column(const Study& study, std::size_t key) {
  TableColumn column{
      "varied/" + study.keys[key], study.units[key], "value of " + study.keys[key] + " in each run", {}, {}};
  std::vector<std::string> words;
  for (const StudyRun& run : study.runs) {
    double number = 0.;
    if (is_number(run.varied[key].second, number)) column.numbers.push_back(number);
    words.push_back(plain(run.varied[key].second));
  }
  if (column.numbers.size() < words.size()) column = {column.path, "", column.description, {}, words};
  return column;
}

/// A number of the runs that have it, beside the numbers of these runs.
template <class Of>
void add_numbers(const Results& results, const std::string& group, const std::string& what, Of number_of,
                 std::vector<TableColumn>& columns) {
  TableColumn run{group + "/run", "", "number of the run", {}, {}}, value{group + "/value", "", what, {}, {}};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::optional<double> number = results[i] ? number_of(*results[i]) : std::nullopt;
    if (!number) continue;
    run.numbers.push_back(static_cast<double>(i));
    value.numbers.push_back(*number);
  }
  columns.push_back(run);
  columns.push_back(value);
}

/// Whether one model of all soils answers some of the runs.
bool are_estimated(const Results& results) {
  return std::any_of(results.begin(), results.end(), [](const auto& r) { return r && r->error_estimate.has_value(); });
}

}  // namespace

std::string study_csv(const Study& study, const Results& results) {
  const bool several = study.cases.size() > 1, sobol = has_matrices(study), estimated = are_estimated(results);
  std::string text = several ? "run,case" : "run";
  if (sobol) text += ",point,matrix";
  for (const std::string& key : study.keys) text += "," + csv_cell(key);
  for (const std::string& path : study.reads) text += "," + csv_cell(path);
  text += std::string(",status,message,checks_failing,warnings") + (estimated ? ",error_estimate" : "") + ",void\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    const RunResult result = results[i].value_or(RunResult{});
    text += std::to_string(i);
    if (several) text += "," + csv_cell(case_of(study, study.runs[i]));
    if (sobol) text += "," + std::to_string(study.runs[i].point) + "," + csv_cell(study.runs[i].matrix);
    for (const auto& [key, value] : study.runs[i].varied) text += "," + csv_cell(plain(value));
    for (std::size_t read = 0; read < study.reads.size(); ++read)
      text += "," + (result.done && result.values[read] ? number_text(*result.values[read]) : std::string());
    text += std::string(",") +
            (result.done  ? "done"
             : results[i] ? "failed"
                          : "missing") +
            "," + csv_cell(result.message) + "," + csv_cell(failing_names(result.doubts.checks)) + "," +
            csv_cell(names_of(result.doubts.warnings));
    if (estimated) text += "," + (result.error_estimate ? number_text(*result.error_estimate) : std::string());
    text += "," + csv_cell(result.doubts.why_void) + "\n";
  }
  return text;
}

std::string study_h5(const Study& study, const Results& results) {
  TableColumn number{"runs/run", "", "number of the run", {}, {}},
      done{"runs/done", "", "1: done, 0: failed or missing", {}, {}};
  TableColumn file{"runs/case", "", "", {}, {}}, message{"runs/message", "", "", {}, {}};
  TableColumn failing{"runs/checks_failing", "", "", {}, {}}, warnings{"runs/warnings", "", "", {}, {}},
      why_void{"runs/void", "", "", {}, {}};
  for (std::size_t i = 0; i < results.size(); ++i) {
    number.numbers.push_back(static_cast<double>(i));
    done.numbers.push_back(results[i] && results[i]->done ? 1. : 0.);
    file.texts.push_back(case_of(study, study.runs[i]));
    message.texts.push_back(results[i] ? results[i]->message : "missing");
    const Doubts doubts = results[i] ? results[i]->doubts : Doubts{};
    failing.texts.push_back(failing_names(doubts.checks));
    warnings.texts.push_back(names_of(doubts.warnings));
    why_void.texts.push_back(doubts.why_void);
  }
  std::vector<TableColumn> columns{number, done, file, message, failing, warnings, why_void};
  if (are_estimated(results))
    add_numbers(
        results, "error_estimate",
        "estimated error of the history of F_T over its peak, as one model answers all soils",
        [](const RunResult& r) { return r.error_estimate; }, columns);
  if (has_matrices(study)) add_matrices(study, columns);
  for (std::size_t key = 0; key < study.keys.size(); ++key) columns.push_back(varied_column(study, key));
  for (std::size_t read = 0; read < study.reads.size(); ++read)
    add_numbers(
        results, "read/" + study.reads[read], study.reads[read] + " of summary.json (SI)",
        [read](const RunResult& r) { return r.done ? r.values[read] : std::nullopt; }, columns);
  return table_file(study.title, columns);
}

int n_failed(const Results& results) {
  return static_cast<int>(
      std::count_if(results.begin(), results.end(), [](const auto& result) { return result && !result->done; }));
}

int n_results(const Results& results) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), [](const auto& r) { return r.has_value(); }));
}

std::string to_json(const Study& study, const Results& results, const StudyAccount& account) {
  Json json{{"title", study.title}, {"program", program_version()}};
  json["cases"] = study.cases;
  json["varied"] = study.keys;
  json["read"] = study.reads;
  if (!account.part.empty()) json["part"] = account.part;
  json["runs"] = account.part.empty() ? static_cast<int>(results.size()) : n_results(results);
  json["missing"] = Json::array();
  for (const MissingRuns& of : account.missing)
    json["missing"].push_back({{"part", of.part}, {"runs", of.runs}, {"works", of.holder}, {"command", of.command}});
  json["failed"] = failures(study, results);
  json["void"] = Json::array();
  for (const auto& [why, runs] : void_runs(results)) json["void"].push_back({{"runs", runs}, {"why", why}});
  json["checks"] = to_json(checks_in_runs(results));
  json["warnings"] = to_json(all_warnings(study, results));
  json["resumed"] = account.resumed ? Json(*account.resumed) : Json(nullptr);
  json["torn_lines"] = account.torn;
  json["lost_processes"] = account.lost;
  json["skipped"] = skipped(results);
  json["solved_alone"] = Json::array();
  for (const auto& [why, n] : reasons_of_own(results)) json["solved_alone"].push_back({{"runs", n}, {"why", why}});
  double work = 0.;
  for (const auto& result : results) work += result ? result->seconds : 0.;
  json["timing"] = {{"processes", account.processes},
                    {"total", account.seconds},
                    {"all_runs", work},
                    {"longest_run", longest(results)}};
  json["versions"] = versions_object();
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string describe(const Study& study, const Results& results, const StudyAccount& account) {
  std::string text = study.title.empty() ? "" : study.title + "\n";
  text += account.part.empty() ? "study       " + std::to_string(results.size()) + " runs"
                               : "part        " + account.part + ", " + std::to_string(n_results(results)) + " runs";
  if (account.resumed.value_or(0) > 0) text += ", " + std::to_string(*account.resumed) + " of them done before";
  text += ", " + std::to_string(n_failed(results)) + " failed\n";
  if (account.lost > 0)
    text += "lost        " + std::to_string(account.lost) + " processes were ended while they computed a run\n";
  text += in_words(account.missing);
  const auto items = skipped(results);
  for (const Json& item : items)
    text += "skipped     " + item["what"].get<std::string>() + ": " + item["why"].get<std::string>() + "\n";
  for (const auto& [why, n] : reasons_of_own(results))
    text += "alone       " + std::to_string(n) + " runs were solved by themselves: " + why + "\n";
  std::size_t n_told = 0;
  for_each_failure(study, results, [&](std::size_t i, const StudyRun& run, const std::string& message) {
    if (n_told++ < n_listed)
      text +=
          "failed      run " + std::to_string(i) + ": " + message + "\n            " + command_of(study, run) + "\n";
  });
  if (n_told > n_listed)
    text += "            and " + std::to_string(n_told - n_listed) + " more, see failed in summary.json\n";
  for (const auto& [why, runs] : void_runs(results))
    text += "VOID        " + std::to_string(runs.size()) + (runs.size() == 1 ? " run (" : " runs (") + listed(runs) +
            "), as the warnings say: " + why + "\n";
  const auto n = static_cast<std::size_t>(n_results(results));
  text += in_words(checks_in_runs(results), n);
  text += in_words(all_warnings(study, results), n);
  return text + "time        " + significant(account.seconds) + " s on " + std::to_string(account.processes) +
         (account.processes == 1 ? " process" : " processes") + ", longest run " + significant(longest(results)) +
         " s\n";
}

}  // namespace upbead
