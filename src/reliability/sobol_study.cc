#include "reliability/sobol_study.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text.h"
#include "output/hdf5_reader.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr const char* wanted = "study.h5 of a study with sample = \"sobol\", made by 'upbead study'";

[[noreturn]] void refuse_study(const std::string& path, const std::string& what) {
  throw InputError({path}, what, std::string("give the folder of ") + wanted);
}

/// The table /runs of study.h5.
struct SobolRuns {
  std::vector<std::string> cases, matrices;
  std::vector<double> points, done;
};

SobolRuns read_runs(const Hdf5Reader& file, const std::string& path) {
  const auto cases = file.texts("/runs/case"), matrices = file.texts("/runs/matrix");
  const auto points = file.numbers("/runs/point"), done = file.numbers("/runs/done");
  if (!cases || !done || cases->empty()) refuse_study(path, "these are no results of a study");
  if (!matrices || !points)
    throw InputError({path}, "the study's runs belong to no matrices: its sample is not \"sobol\"",
                     "write sample = \"sobol\" and n = 256, say, into the study and run it again");
  const std::size_t n = cases->size();
  if (matrices->size() != n || points->values.size() != n || done->values.size() != n)
    refuse_study(path, "its tables are not equally long");
  return {*cases, *matrices, points->values, done->values};
}

/// The keys in the order of the matrices of the first point.
std::vector<std::string> keys_of(const SobolRuns& runs, const std::string& path) {
  std::vector<std::string> keys;
  for (std::size_t i = 2; i < runs.matrices.size() && runs.points[i] == runs.points[0]; ++i) {
    if (runs.cases[i] != runs.cases[0]) break;
    keys.push_back(runs.matrices[i]);
  }
  const std::size_t rows = keys.size() + 2;
  bool sound = !keys.empty() && runs.matrices.size() % rows == 0;
  for (std::size_t i = 0; sound && i < runs.matrices.size(); ++i) {
    const std::size_t m = i % rows;
    sound = runs.matrices[i] == (m == 0   ? "A"
                                 : m == 1 ? "B"
                                          : keys[m - 2]) &&
            runs.points[i] == runs.points[i - m] && runs.cases[i] == runs.cases[i - m];
  }
  if (!sound) refuse_study(path, "its runs are not in the order of a Sobol sample");
  return keys;
}

/// The number of each run; none where it failed or has no such number.
std::vector<std::optional<double>> values_of_runs(const Hdf5Reader& file, const std::string& path,
                                                  const std::string& number, std::size_t n_runs) {
  const auto run = file.numbers("/read/" + number + "/run"), value = file.numbers("/read/" + number + "/value");
  std::vector<std::optional<double>> values(n_runs);
  if (!run || !value) return values;  // no run has it, so that both are empty
  if (run->values.size() != value->values.size()) refuse_study(path, "its tables of '" + number + "' do not fit");
  for (std::size_t i = 0; i < run->values.size(); ++i) {
    const double at = run->values[i];
    if (!(at >= 0. && at < static_cast<double>(n_runs))) refuse_study(path, "'" + number + "' is of no run");
    values[static_cast<std::size_t>(at)] = value->values[i];
  }
  return values;
}

/// The summary.json beside study.h5.
struct StudySummary {
  std::string path;
  nlohmann::json json;
};

StudySummary summary_in(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "summary.json").string();
  std::ifstream file(path);
  return {path, nlohmann::json::parse(file, nullptr, false)};
}

/// The runs, of which those are not done whose numbers are void.
SobolRuns without_void(SobolRuns runs, const nlohmann::json& summary) {
  if (!summary.is_object() || !summary.contains("void")) return runs;
  for (const auto& reason : summary["void"])
    for (const auto& run : reason["runs"])
      if (const auto at = run.get<std::size_t>(); at < runs.done.size()) runs.done[at] = 0.;
  return runs;
}

/// The numbers that were read, as it lists them.
std::vector<std::string> numbers_of(const StudySummary& of) {
  const auto& [path, summary] = of;
  std::vector<std::string> numbers;
  if (summary.is_object() && summary.contains("read") && summary["read"].is_array())
    for (const auto& number : summary["read"])
      if (number.is_string()) numbers.push_back(number.get<std::string>());
  if (numbers.empty()) refuse_study(path, "it does not tell what the study read");
  return numbers;
}

SobolOutputs outputs_of(const SobolRuns& runs, const std::string& case_file, const std::string& number,
                        const std::vector<std::optional<double>>& values, std::size_t rows) {
  SobolOutputs outputs;
  outputs.case_file = case_file;
  outputs.number = number;
  for (std::size_t first = 0; first < values.size(); first += rows) {
    if (runs.cases[first] != case_file) continue;
    std::vector<double> point;
    for (std::size_t i = first; i < first + rows; ++i) {
      if (runs.done[i] == 0.)
        ++outputs.failed;
      else if (!values[i])
        ++outputs.lacking;
      else
        point.push_back(*values[i]);
    }
    if (point.size() == rows)
      outputs.points.push_back(point);
    else
      ++outputs.left_out;
  }
  return outputs;
}

}  // namespace

SobolStudy read_sobol_study(const std::string& folder, const std::vector<std::string>& of) {
  const std::string path = (std::filesystem::path(folder) / "study.h5").string();
  const Hdf5Reader file(path, wanted);
  const StudySummary summary = summary_in(folder);
  const SobolRuns runs = without_void(read_runs(file, path), summary.json);
  SobolStudy study{file.text_attribute("/", "title").value_or(""), keys_of(runs, path), {}};
  const std::vector<std::string> known = numbers_of(summary);
  for (const std::string& number : of)
    if (std::find(known.begin(), known.end(), number) == known.end())
      throw InputError({"--of " + number}, "the study has not read '" + number + "'",
                       suggestion(number, known, "numbers that it has read"));
  std::vector<std::string> cases;
  for (const std::string& name : runs.cases)
    if (std::find(cases.begin(), cases.end(), name) == cases.end()) cases.push_back(name);
  for (const std::string& number : of.empty() ? known : of) {
    const auto values = values_of_runs(file, path, number, runs.cases.size());
    for (const std::string& name : cases)
      study.outputs.push_back(outputs_of(runs, name, number, values, study.keys.size() + 2));
  }
  return study;
}

}  // namespace upbead
