#include "study_tables.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "summary_reader.h"

namespace upbead {

namespace {

constexpr double most_runs = 1e5;

/// The study that is checked, and the list of mistakes.
struct Checker {
  const StudyTables& study;
  const std::vector<Axis>& axes;
  const Document& document;
  Diagnostics& report;

  void add(const std::string& path, const std::string& what, const std::string& cure) const {
    report.add(document.place(path), what, cure);
  }
};

void check_cases(const Checker& check) {
  const StudyTables& study = check.study;
  if (!study.one_case.empty() && !study.cases.empty())
    check.add("cases", "both 'case' and 'cases' are given", "keep one of them");
  if (study.one_case.empty() && study.cases.empty())
    check.add("case", "the study has no case", "add case = the path of a case file");
  if (std::set<std::string>(study.cases.begin(), study.cases.end()).size() != study.cases.size())
    check.add("cases", "a case is named twice", "remove one of them");
  if (check.axes.empty() && (study.cases.size() < 2 || has_draws(study.sample)))
    check.add("vary", "nothing is varied", "add a table such as [vary.\"regions.seabed.shear_modulus\"] with values");
}

/// Values, a range and a distribution exclude one another, and not every kind of sample allows each of them.
bool check_kind(const Checker& check, const VaryTable& vary, const std::string& path) {
  const bool random = has_draws(check.study.sample);
  const int given = (vary.values.empty() ? 0 : 1) + (vary.from ? 1 : 0) + (vary.distribution ? 1 : 0);
  if (given != 1)
    check.add(path, "[" + path + "] has " + (given == 0 ? "no values" : "values of more than one kind"),
              random ? "give either values or distribution" : "give either values, or from, to and n");
  else if (random && vary.from)
    check.add(path + ".from",
              std::string("a range does not belong where sample = \"") +
                  (check.study.sample == Sampling::sobol ? "sobol" : "random") + "\"",
              "write distribution = \"uniform\" with low and high");
  else if (!random && vary.distribution)
    check.add(path + ".distribution", "a distribution belongs only where sample = \"random\" or \"sobol\"",
              "write from, to and n, or sample = \"random\"");
  else
    return true;
  return false;
}

void check_range(const Checker& check, const VaryTable& vary, const std::string& path) {
  if (!vary.from) return;
  if (!vary.to || !vary.n)
    check.add(path, std::string("'") + (vary.to ? "n" : "to") + "' is missing in [" + path + "]",
              "a range needs from, to and n");
  else if (vary.spacing == Spacing::log && *vary.from * *vary.to <= 0.)
    check.add(
        path + ".spacing",
        "a range from " + number_text(*vary.from) + " to " + number_text(*vary.to) + " has no logarithmic spacing",
        "give ends of the same sign, neither of them 0");
}

void check_distribution(const Checker& check, const VaryTable& vary, const std::string& path) {
  if (vary.low && vary.high && *vary.low >= *vary.high)
    check.add(path + ".high", "high = " + number_text(*vary.high) + " is not above low = " + number_text(*vary.low),
              "give the least value as low and the largest as high");
  if (vary.distribution == DrawnBy::log_uniform && vary.low && *vary.low <= 0.)
    check.add(path + ".low", "low = " + number_text(*vary.low) + " has no logarithm", "give low above 0");
  if (vary.distribution == DrawnBy::log_normal && vary.mean && *vary.mean <= 0.)
    check.add(path + ".mean", "mean = " + number_text(*vary.mean) + " has no logarithm", "give a mean above 0");
}

void check_axes(const Checker& check) {
  bool sound = true;
  for (const auto& [key, vary] : check.axes) {
    const std::string path = dotted("vary", key);
    if (!check.report.sound(path) || !check_kind(check, vary, path)) {
      sound = false;
      continue;
    }
    check_range(check, vary, path);
    check_distribution(check, vary, path);
    sound = sound && check.report.sound(path);
    if (check.study.set.count(key) != 0)
      check.add(path, "'" + key + "' is varied and set", "remove it from [set] or from [vary]");
  }
  if (!sound || check.axes.empty() || !check.report.sound("n")) return;
  if (check.study.sample == Sampling::paired)
    for (const Axis& axis : check.axes)
      if (values_of(axis.vary).size() != values_of(check.axes.front().vary).size())
        return check.add(dotted("vary", axis.key),
                         "'" + axis.key + "' has " + std::to_string(values_of(axis.vary).size()) + " values, '" +
                             check.axes.front().key + "' has " +
                             std::to_string(values_of(check.axes.front().vary).size()),
                         "give paired keys equally many values, or write sample = \"grid\"");
  if (check.study.sample == Sampling::sobol && check.axes.size() > static_cast<std::size_t>(most_sobol_keys))
    return check.add("vary",
                     "a Sobol sample of " + std::to_string(check.axes.size()) + " keys, more than " +
                         std::to_string(most_sobol_keys),
                     "vary fewer keys");
  const double n = number_of_runs(check.study, check.axes);
  if (n > most_runs)
    check.add("vary", "the study has " + number_text(n) + " runs, more than " + number_text(most_runs),
              "vary fewer values");
}

bool has_words(const VaryTable& vary) {
  return std::any_of(vary.values.begin(), vary.values.end(), [](const Literal& value) { return !value.is_number; });
}

void check_followers(const Checker& check) {
  std::vector<std::string> keys;
  for (const Axis& axis : check.axes) keys.push_back(axis.key);
  for (const auto& [key, follow] : check.study.follow) {
    const std::string path = dotted("follow", key);
    if (!check.report.sound(path)) continue;
    const auto leader = std::find(keys.begin(), keys.end(), follow.key);
    if (leader == keys.end())
      check.add(path + ".key", "'" + follow.key + "' is not varied", suggestion(follow.key, keys, "varied keys"));
    else if (has_words(check.axes[static_cast<std::size_t>(leader - keys.begin())].vary))
      check.add(path + ".key", "'" + follow.key + "' has values that are no numbers", "vary both keys, paired");
    if (check.study.set.count(key) != 0 || check.study.vary.count(key) != 0)
      check.add(path, "'" + key + "' follows and is " + (check.study.set.count(key) != 0 ? "set" : "varied"),
                "keep one of them");
  }
}

void check_reads(const Checker& check) {
  if (!check.report.sound("read")) return;
  for (const std::string& path : check.study.read)
    if (const std::string objection = objection_to_reading(path); !objection.empty())
      check.add("read", "'" + path + "' cannot be read: " + objection,
                objection == not_in_a_summary ? suggestion(path, readable_paths(), "numbers of summary.json") : "");
  const std::set<std::string> different(check.study.read.begin(), check.study.read.end());
  if (different.size() != check.study.read.size()) check.add("read", "a number is read twice", "remove one of them");
}

}  // namespace

void check_study(const StudyTables& study, const std::vector<Axis>& axes, const Document& document,
                 Diagnostics& report) {
  const Checker check{study, axes, document, report};
  check_cases(check);
  check_axes(check);
  check_followers(check);
  check_reads(check);
}

void require_quoted_keys(const Document& document) {
  Diagnostics mistakes;
  for (const std::string table : {"vary", "follow"}) {
    const Node* node = document.find(table);
    if (!node || !node->table()) continue;
    for (const auto& [key, entry] : *node->table())
      for (const auto& [below, inner] : entry.table() ? *entry.table() : NodeTable())
        if (inner.table())
          mistakes.add(inner.place, "the key '" + key + "." + below + "...' is written without quotes",
                       "write [" + table + ".\"" + key + "." + below + "...\"]");
  }
  mistakes.throw_if_any();
}

}  // namespace upbead
