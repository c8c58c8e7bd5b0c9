// study.csv and study.h5.
#include <algorithm>
#include <cstdlib>

#include "output/table_file.h"
#include "study_report.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

/// A cell of a CSV file: quoted where it holds what separates cells.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
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

void add_read(const Study& study, const Results& results, std::size_t read, std::vector<TableColumn>& columns) {
  const std::string& path = study.reads[read];
  TableColumn run{"read/" + path + "/run", "", "number of the run", {}, {}};
  TableColumn value{"read/" + path + "/value", "", path + " of summary.json (SI)", {}, {}};
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i]->done && results[i]->values[read]) {
      run.numbers.push_back(static_cast<double>(i));
      value.numbers.push_back(*results[i]->values[read]);
    }
  columns.push_back(run);
  columns.push_back(value);
}

}  // namespace

std::string study_csv(const Study& study, const Results& results) {
  const bool several = study.cases.size() > 1;
  std::string text = several ? "run,case" : "run";
  for (const std::string& key : study.keys) text += "," + cell(key);
  for (const std::string& path : study.reads) text += "," + cell(path);
  text += ",status,message\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    const RunResult& result = *results[i];
    text += std::to_string(i);
    if (several) text += "," + cell(case_of(study, study.runs[i]));
    for (const auto& [key, value] : study.runs[i].varied) text += "," + cell(plain(value));
    for (std::size_t read = 0; read < study.reads.size(); ++read)
      text += "," + (result.done && result.values[read] ? number_text(*result.values[read]) : std::string());
    text += std::string(",") + (result.done ? "done" : "failed") + "," + cell(result.message) + "\n";
  }
  return text;
}

std::string study_h5(const Study& study, const Results& results) {
  TableColumn number{"runs/run", "", "number of the run", {}, {}}, done{"runs/done", "", "1: done, 0: failed", {}, {}};
  TableColumn file{"runs/case", "", "", {}, {}}, message{"runs/message", "", "", {}, {}};
  for (std::size_t i = 0; i < results.size(); ++i) {
    number.numbers.push_back(static_cast<double>(i));
    done.numbers.push_back(results[i]->done ? 1. : 0.);
    file.texts.push_back(case_of(study, study.runs[i]));
    message.texts.push_back(results[i]->message);
  }
  std::vector<TableColumn> columns{number, done, file, message};
  for (std::size_t key = 0; key < study.keys.size(); ++key) columns.push_back(varied_column(study, key));
  for (std::size_t read = 0; read < study.reads.size(); ++read) add_read(study, results, read, columns);
  return table_file(study.title, columns);
}

}  // namespace upbead
