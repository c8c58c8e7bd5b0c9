#include <cmath>

#include "base/text.h"
#include "input/report_table.h"
#include "study_tables.h"

namespace upbead {

namespace {

constexpr double largest_exact = 9007199254740992.;  // 2^53

Diagnostics refuse(const Node& node, const KeyInfo& key, const std::string& expected) {
  return {{node.place, key.name + ": expected " + expected + ", found " + found(node), "give the " + key.meaning()}};
}

Diagnostics read_settings(const Node& node, const KeyInfo& key, const std::string& path,
                          std::map<std::string, Literal>& value) {
  Diagnostics all;
  for (const auto& [name, entry] : *node.table()) {
    const std::string below = path.empty() ? name : path + "." + name;
    if (entry.table())
      all.add(read_settings(entry, key, below, value));
    else
      all.add(read_value(entry, key, value[below]));
  }
  return all;
}

const std::vector<std::pair<std::string, Sampling>> sampling_words{
    {"grid", Sampling::grid}, {"paired", Sampling::paired}, {"random", Sampling::random}, {"sobol", Sampling::sobol}};
const std::vector<std::pair<std::string, StudyShare>> share_words{
    {"all", StudyShare::all}, {"soils", StudyShare::soils}, {"none", StudyShare::none}};
const std::vector<std::pair<std::string, Spacing>> spacing_words{{"linear", Spacing::linear}, {"log", Spacing::log}};
const std::vector<std::pair<std::string, DrawnBy>> distribution_words{{"uniform", DrawnBy::uniform},
                                                                      {"log_uniform", DrawnBy::log_uniform},
                                                                      {"normal", DrawnBy::normal},
                                                                      {"log_normal", DrawnBy::log_normal}};

void declare_range(TableSchema<VaryTable>& table) {
  const auto ranged = [](const VaryTable& vary) { return vary.from.has_value(); };
  table.key("from", &VaryTable::from).doc("first value of a range; or values");
  table.key("to", &VaryTable::to).doc("last value of a range").when("from", ranged, "with from");
  table.key("n", &VaryTable::n)
      .range(from_to(2., 1e5))
      .doc("number of values of a range")
      .when("from", ranged, "with from");
  table.choice("spacing", &VaryTable::spacing, spacing_words)
      .doc("how the values of a range are spaced")
      .when("from", ranged, "with from");
}

void declare_distribution(TableSchema<VaryTable>& table) {
  const auto bounded = [](const VaryTable& vary) {
    return vary.distribution == DrawnBy::uniform || vary.distribution == DrawnBy::log_uniform;
  };
  const auto bell = [](const VaryTable& vary) {
    return vary.distribution == DrawnBy::normal || vary.distribution == DrawnBy::log_normal;
  };
  table.choice("distribution", &VaryTable::distribution, distribution_words)
      .doc("distribution of random values; or values, which are then drawn with equal chances");
  table.key("low", &VaryTable::low)
      .required()
      .doc("least value")
      .when("distribution", bounded, "of uniform and log_uniform");
  table.key("high", &VaryTable::high)
      .required()
      .doc("largest value")
      .when("distribution", bounded, "of uniform and log_uniform");
  table.key("mean", &VaryTable::mean)
      .required()
      .doc("mean of the distribution")
      .when("distribution", bell, "of normal and log_normal");
  table.key("cov", &VaryTable::cov)
      .range(at_least(0.))
      .required()
      .doc("standard deviation over the mean")
      .when("distribution", bell, "of normal and log_normal");
}

TableSchema<VaryTable> vary_schema() {
  TableSchema<VaryTable> table;
  table.key("values", &VaryTable::values).doc("list of numbers or words");
  declare_range(table);
  declare_distribution(table);
  return table;
}

TableSchema<FollowTable> follow_schema() {
  TableSchema<FollowTable> table;
  table.key("key", &FollowTable::key).required().doc("varied key that it follows");
  table.key("factor", &FollowTable::factor).doc("its value over that of the key that it follows");
  return table;
}

}  // namespace

Literal literal(double number) {
  const bool whole = std::trunc(number) == number && std::abs(number) < largest_exact;
  return {whole ? std::to_string(static_cast<std::int64_t>(number)) : to_toml(number), true, number};
}

Diagnostics read_value(const Node& node, const KeyInfo& key, Literal& value) {
  if (const auto* truth = std::get_if<bool>(&node.value)) {
    value = {to_toml(*truth)};
  } else if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    value = literal(static_cast<double>(*whole));
  } else if (const auto* number = std::get_if<double>(&node.value)) {
    value = literal(*number);
  } else if (node.text()) {
    value = {to_toml(*node.text())};
  } else if (node.array()) {
    std::vector<Literal> items;
    Diagnostics wrong = read_value(node, key, items);
    if (!wrong.empty()) return wrong;
    value = {print_value(key, items)};
  } else {
    return refuse(node, key, "a number, a word, true, false or a list");
  }
  return {};
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Literal>& value) {
  if (!node.array()) return refuse(node, key, type_text(key, &value));
  value.clear();
  Diagnostics all;
  for (const Node& item : *node.array()) all.add(read_value(item, key, value.emplace_back()));
  return all;
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, Literal>& value) {
  if (!node.table()) return refuse(node, key, type_text(key, &value));
  return read_settings(node, key, "", value);
}

std::string type_text(const KeyInfo&, const Literal*) {
  return "a value";
}
std::string type_text(const KeyInfo&, const std::vector<Literal>*) {
  return "a list of values";
}
std::string type_text(const KeyInfo&, const std::map<std::string, Literal>*) {
  return "a table of values";
}

std::string print_value(const KeyInfo&, const Literal& value) {
  return value.toml;
}

std::string print_value(const KeyInfo&, const std::vector<Literal>& value) {
  std::vector<std::string> items;
  for (const Literal& item : value) items.push_back(item.toml);
  return items.empty() ? "" : "[" + join(items) + "]";
}

std::string print_value(const KeyInfo&, const std::map<std::string, Literal>& value) {
  std::vector<std::string> items;
  for (const auto& [name, item] : value) items.push_back(to_toml(name) + " = " + item.toml);
  return items.empty() ? "" : "{ " + join(items) + " }";
}

const std::vector<std::string>& default_reads() {
  static const std::vector<std::string> list{"response.shear_to_force_ratio", "response.peak_shear",
                                             "response.peak_force", "response.peak_displacement"};
  return list;
}

TableSchema<StudyTables> study_schema() {
  const auto drawn = [](const StudyTables& study) { return has_draws(study.sample); };
  TableSchema<StudyTables> table;
  table.key("title", &StudyTables::title).doc("title of the study");
  table.key("case", &StudyTables::one_case).doc("path of the case; or cases");
  table.key("cases", &StudyTables::cases).doc("list of the paths of several cases; each gets the whole sample");
  table.choice("sample", &StudyTables::sample, sampling_words)
      .doc(
          "how varied keys combine; grid: every value with every other; paired: the first ones together, then the "
          "second ones; random: n draws; sobol: n (keys + 2) runs, of which `upbead indices` makes Sobol indices");
  table.key("n", &StudyTables::n)
      .range(from_to(1., 1e5))
      .required()
      .doc("number of draws; of points of a Sobol sample, best a power of 2")
      .when("sample", drawn, "where sample = random or sobol");
  table.key("seed", &StudyTables::seed)
      .range(at_least(0.))
      .doc("seed of the draws; a random draw depends on it, on the key and on its number only")
      .when("sample", drawn, "where sample = random or sobol");
  table.key("read", &StudyTables::read)
      .fallback("peak F_T, peak P, their ratio and the peak displacement")
      .doc("list of numbers to read of each run, as paths into its summary.json");
  table.key("summaries", &StudyTables::summaries)
      .doc("whether to keep the whole summary.json of each run, as runs/NUMBER.json");
  table.choice("share", &StudyTables::share, share_words)
      .doc(
          "what runs may take over from each other; all: each stage that is the same; soils: besides, one model "
          "answers many soils, each within its error_estimate; none: "
          "nothing, every run is meshed and solved anew");
  table.key("set", &StudyTables::set).doc("values that all runs have, by key of the case");
  table.tables("vary", &StudyTables::vary, vary_schema())
      .doc(
          "One table per varied key, its dotted path in quotes: `[vary.\"regions.seabed.shear_modulus\"]`. Exactly "
          "one of values, from and distribution; distribution only where sample = random or sobol, from only "
          "elsewhere.");
  table.tables("follow", &StudyTables::follow, follow_schema())
      .doc("Keys that go along with a varied one, their dotted paths in quotes.");
  table.table("report", &StudyTables::report, report_table()).doc(report_table_doc);
  return table;
}

}  // namespace upbead
