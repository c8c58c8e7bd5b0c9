#include "study/study.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/fingerprint.h"
#include "base/version.h"
#include "case/case_schema.h"
#include "case/input_files.h"
#include "mesh/geo_script.h"
#include "study_tables.h"
#include "upbead/case/case.h"
#include "upbead/mesh/request.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// The settings of one run: fixed ones first, so that varied ones override them.
StudyRun make_run(const StudyTables& tables, const std::vector<Axis>& axes, const Sampler& sampler, int case_index,
                  int number) {
  StudyRun run;
  run.case_index = case_index;
  run.point = sampler.point(number);
  run.matrix = sampler.matrix(number);
  for (const auto& [key, value] : tables.set) run.settings.emplace_back(key, value.toml);
  const std::vector<Literal> values = sampler.values(number);
  for (std::size_t a = 0; a < axes.size(); ++a) run.varied.emplace_back(axes[a].key, values[a].toml);
  run.settings.insert(run.settings.end(), run.varied.begin(), run.varied.end());
  for (const auto& [key, follow] : tables.follow)
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].key == follow.key) run.settings.emplace_back(key, literal(follow.factor * values[a].number).toml);
  return run;
}

/// A mistake in a value that the study has set is reported at its place in the study.
Diagnostic seen_from_study(const Diagnostic& mistake, const StudyRun& run, const Document& document) {
  const std::string mark = "--set ";
  if (mistake.place.file.rfind(mark, 0) != 0) return mistake;
  const std::vector<std::string> overrides = overrides_of(run);
  const auto found = std::find(overrides.begin(), overrides.end(), mistake.place.file.substr(mark.size()));
  if (found == overrides.end()) return mistake;
  const std::string& key = run.settings[static_cast<std::size_t>(found - overrides.begin())].first;
  for (const std::string& path : {dotted("vary", key), dotted("follow", key), "set." + key})
    if (document.find(path)) return {document.place(path), *found + ": " + mistake.what, mistake.cure};
  return {document.place("set"), *found + ": " + mistake.what, mistake.cure};
}

constexpr int most_attempts = 1000;

/// The case with the settings of its first run that can be read. Where none can, the mistakes of the first run are
/// reported.
std::optional<Case> first_sound_case(const Study& study, int index, const Document& document, Diagnostics& report) {
  std::optional<InputError> first;
  const StudyRun* first_run = nullptr;
  int attempts = 0;
  for (const StudyRun& run : study.runs) {
    if (run.case_index != index || ++attempts > most_attempts) continue;
    try {
      Case problem = read_case(study.cases[static_cast<std::size_t>(index)], overrides_of(run));
      require_loads(problem);
      return problem;
    } catch (const InputError& error) {
      if (first) continue;
      first = error;
      first_run = &run;
    }
  }
  if (first)
    for (const Diagnostic& mistake : first->diagnostics()) report.add(seen_from_study(mistake, *first_run, document));
  return std::nullopt;
}

/// Adds files that are not yet known.
void add_inputs(Study& study, const std::vector<InputFile>& files) {
  for (const InputFile& file : files)
    if (std::none_of(study.inputs.begin(), study.inputs.end(),
                     [&file](const InputFile& known) { return known.path == file.path; }))
      study.inputs.push_back(file);
}

/// Adds all files on which a case depends, with the words that its runs set: such a word may name a file, a folder, or
/// decide which files are read.
void add_case(Study& study, int index) {
  std::set<std::vector<std::string>> seen;
  for (const StudyRun& run : study.runs) {
    if (run.case_index != index) continue;
    std::vector<std::string> words;
    for (const auto& [key, value] : run.settings)
      if (value.front() == '"') words.push_back(std::string(key).append("=").append(value));
    if (!seen.insert(words).second) continue;
    try {
      add_inputs(study, input_files(read_case(study.cases[static_cast<std::size_t>(index)], overrides_of(run))));
    } catch (const InputError&) {  // told where the run is made; it reads no file
    }
  }
}

/// Units, by dotted key, of every number of the case, and of the parameters of its .geo whose comments name a unit.
std::map<std::string, std::string> units_of_keys(const Case& problem) {
  std::map<std::string, std::string> units;
  CaseTables tables = *problem.tables;
  case_schema().visit_numbers(
      tables, "", [&units](const KeyInfo& key, const std::string& path, double&) { units.emplace(path, key.unit); });
  for (const GeoParameter& parameter : geo_parameters(mesh_request(problem).file)) {
    const std::size_t colon = parameter.description.find(':');
    const std::string unit = colon == std::string::npos ? "" : parameter.description.substr(0, colon);
    units[dotted("mesh.parameters", parameter.name)] = unit == "-" ? "" : unit;
  }
  return units;
}

void make_runs(Study& study, const StudyTables& tables, const std::vector<Axis>& axes) {
  const Sampler sampler(tables, axes);
  for (int c = 0; c < static_cast<int>(study.cases.size()); ++c)
    for (int i = 0; i < sampler.n_runs(); ++i) study.runs.push_back(make_run(tables, axes, sampler, c, i));
}

}  // namespace

std::vector<Axis> axes_of(const StudyTables& tables, const Document& document) {
  std::vector<Axis> axes;
  const Node* vary = document.find("vary");
  if (vary && vary->table())
    for (const auto& [key, node] : *vary->table())
      if (tables.vary.count(key) != 0) axes.push_back({key, tables.vary.at(key)});
  return axes;
}

std::vector<std::string> overrides_of(const StudyRun& run) {
  std::vector<std::string> list;
  for (const auto& [key, value] : run.settings) list.push_back(key + "=" + value);
  return list;
}

Study read_study(const std::string& path, const std::vector<std::string>& overrides) {
  const Document document(path, overrides);
  require_quoted_keys(document);
  StudyTables tables;
  Diagnostics report;
  study_schema().read(document.root(), "", tables, report);
  const std::vector<Axis> axes = axes_of(tables, document);
  check_study(tables, axes, document, report);
  report.throw_if_any(path);

  Study study;
  study.title = tables.title;
  study.stem = fs::path(path).stem().string();
  if (!tables.one_case.empty()) tables.cases = {tables.one_case};
  for (const std::string& file : tables.cases)
    study.cases.push_back((fs::path(path).parent_path() / file).lexically_normal().string());
  for (const Axis& axis : axes) study.keys.push_back(axis.key);
  study.reads = tables.read.empty() ? default_reads() : tables.read;
  study.summaries = tables.summaries;
  study.share = tables.share;
  make_runs(study, tables, axes);

  Fingerprint fingerprint;
  fingerprint.add(program_version());
  study.inputs.push_back({path, {path}});
  for (const std::string& text : overrides) fingerprint.add(text);
  for (int c = 0; c < static_cast<int>(study.cases.size()); ++c)
    if (const auto problem = first_sound_case(study, c, document, report)) {
      add_case(study, c);
      if (c > 0) continue;
      const std::map<std::string, std::string> units = units_of_keys(*problem);
      for (const std::string& key : study.keys) study.units.push_back(units.count(key) != 0 ? units.at(key) : "");
    }
  report.throw_if_any(path);
  for (const InputFile& file : study.inputs) fingerprint.add_file(file.path);
  study.fingerprint = fingerprint.value();
  return study;
}

std::string study_reference() {
  return reference(study_schema());
}

std::string study_json_schema() {
  return study_schema().json_schema("a study of upbead");
}

}  // namespace upbead
