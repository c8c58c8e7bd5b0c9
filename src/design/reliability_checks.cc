#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "design/design_tables.h"
#include "design/water_levels.h"
#include "upbead/input/document.h"

namespace upbead {

const std::vector<RandomFactor> random_factors{
    {"force", "", 1.},  {"uplift", "", 1.},       {"friction", "", 1.},
    {"weight", "", 1.}, {"wave", "", 1.},         {"significant_height", "", 1.},
    {"period", "", 1.}, {"water_level", "m", 0.}, {"sliding", "", 1.}};

const RandomFactor* find_factor(const std::string& name) {
  const auto found = std::find_if(random_factors.begin(), random_factors.end(),
                                  [&name](const RandomFactor& factor) { return factor.name == name; });
  return found == random_factors.end() ? nullptr : &*found;
}

std::string random_wave(const DesignTables& tables) {
  const std::string name = tables.reliability ? tables.reliability->wave : "";
  if (!name.empty()) return tables.waves.count(name) ? name : "";
  return tables.waves.size() == 1 ? tables.waves.begin()->first : "";
}

namespace {

struct FoundNumber {
  double* number = nullptr;
  std::string unit;
};

/// Visits the numbers of one table of the design.
template <class T>
void look(T& table, const TableSchema<T>& schema, const std::string& path, const std::string& key, FoundNumber& out) {
  schema.visit_numbers(table, path, [&](const KeyInfo& info, const std::string& at, double& number) {
    if (at == key) out = {&number, info.unit};
  });
}

bool may_act_on(const DesignTables& tables, const std::string& key) {
  const std::string wave = dotted("waves", random_wave(tables)) + ".";
  for (const std::string& begin : {std::string("section."), std::string("fluid."), std::string("duration."), wave})
    if (key.rfind(begin, 0) == 0) return true;
  return key == "limits.sliding" || key == "limits.base_pressure";
}

FoundNumber found_at(DesignTables& tables, const std::string& key) {
  FoundNumber found;
  if (tables.dynamics)
    for (auto& [of_soil, number] : tables.dynamics->soil)
      if (is_same_key(of_soil, key)) found.number = &number;
  if (may_act_on(tables, key)) look(tables, design_schema(), "", key, found);
  return found;
}

}  // namespace

std::optional<double> certain_value(const DesignTables& tables, const std::string& acts_on) {
  if (const RandomFactor* factor = find_factor(acts_on)) return factor->certain;
  DesignTables copy = tables;
  const double* number = number_at(copy, acts_on);
  return number ? std::optional(*number) : std::nullopt;
}

namespace {

bool has_moments(RandomKind kind) {
  return kind != RandomKind::uniform && kind != RandomKind::triangular;
}

/// The mean, which is that of the design where none is given; of a uniform or triangular one the middle.
double middle_of(const RandomVariable& v, double of_design) {
  if (has_moments(v.kind)) return v.mean.value_or(of_design);
  return v.mode.value_or(0.5 * (*v.low + *v.high));
}

/// What is contradictory in the moments of a variable whose mean is known.
Diagnostics moments_of(const RandomVariable& v, double mean) {
  Diagnostics list;
  if (v.cov && v.deviation)
    list.add(at_key("cov"), "both 'cov' and 'deviation' are given", "keep one of them");
  else if (!v.cov && !v.deviation)
    list.add(at_key(""), "neither 'cov' nor 'deviation' is given", "add one of them, with its source beside it");
  else if (v.cov && mean == 0.)
    list.add(at_key("cov"), "'cov' means nothing with a mean of 0", "give deviation instead");
  const bool from_location = v.kind == RandomKind::lognormal || v.kind == RandomKind::weibull;
  if (from_location && mean <= v.location.value_or(0.))
    list.add(at_key(v.mean ? "mean" : ""),
             "the mean " + significant(mean, 6) + " is not above the least value of the distribution, " +
                 significant(v.location.value_or(0.), 6),
             "give a mean above it, another location, or distribution = \"normal\"");
  return list;
}

Diagnostics ends_of(const RandomVariable& v) {
  Diagnostics list;
  if (!has_moments(v.kind))
    for (const auto& [key, end] : {std::pair("low", v.low), std::pair("high", v.high)})
      if (!end) list.add(at_key(""), std::string("'") + key + "' is missing", std::string("add ") + key);
  if (v.low && v.high && *v.low >= *v.high)
    list.add(at_key("low"), "low = " + significant(*v.low, 6) + " is not below high = " + significant(*v.high, 6),
             "give low < high");
  else if (v.mode && v.low && v.high && (*v.mode < *v.low || *v.mode > *v.high))
    list.add(at_key("mode"), "mode = " + significant(*v.mode, 6) + " is not between low and high",
             "give low <= mode <= high");
  return list;
}

Diagnostics diagnose(const RandomVariable& v, const DesignTables& tables) {
  Diagnostics list = ends_of(v);
  const std::optional<double> certain = certain_value(tables, v.acts_on);
  if (!certain)
    list.add(
        at_key("acts_on"),
        "acts_on = " + in_quotes(v.acts_on) +
            " is neither a factor nor a number that the design gives in [section], "
            "[fluid], [duration], the wave's table, limits.sliding or limits.base_pressure, nor a key of the soils of "
            "[dynamics] model",
        "give such a number in the design, or a factor: force, uplift, friction, weight, wave, "
        "significant_height, period, water_level, sliding");
  else if (has_moments(v.kind))
    list.add(moments_of(v, v.mean.value_or(*certain)));
  return list;
}

void add_at(const std::string& path, const Diagnostics& found, const Document& document, Diagnostics& report) {
  if (!report.sound(path)) return;
  for (const auto& [at, what, cure] : found)
    report.add(document.place(at.key.empty() ? path : dotted(path, at.key)), "[" + path + "]: " + what, cure);
}

void check_variables(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const ReliabilityTable& table = *tables.reliability;
  if (table.variables.empty() && report.sound("reliability.variables"))
    report.add(document.place("reliability"), "[reliability]: nothing is random",
               "add [reliability.variables.NAME] with acts_on, distribution and cov");
  std::map<std::string, std::string> taken;  // name of the variable by what it acts on
  for (const auto& [name, variable] : table.variables) {
    const std::string path = dotted("reliability.variables", name);
    Diagnostics found = diagnose(variable, tables);
    const auto [before, is_new] = taken.emplace(variable.acts_on, name);
    if (!is_new)
      found.add(at_key("acts_on"), in_quotes(before->second) + " acts on " + in_quotes(variable.acts_on) + ", too",
                "let one variable act on it, and another on a factor");
    add_at(path, found, document, report);
  }
}

/// The section with all means is a section as one that is given.
void check_means(const DesignTables& tables, const Document& document, Diagnostics& report) {
  for (const char* table : {"reliability", "section", "fluid", "gravity"})
    if (!report.sound(table)) return;
  const DesignTables means = at_means(tables);
  for (const auto& [at, what, cure] : diagnose(means.section))
    report.add(document.place("reliability.variables"), "[reliability.variables]: with the means " + what, cure);
  for (const auto& [name, variable] : tables.reliability->variables)
    if (variable.acts_on == "water_level")
      if (const Diagnostic wrong = misfit({name, middle_of(variable, 0.)}, means.section, means.water);
          !wrong.what.empty())
        report.add(document.place(dotted("reliability.variables", name)), "[reliability.variables]: " + wrong.what,
                   wrong.cure);
}

void check_correlations(const ReliabilityTable& table, const Document& document, Diagnostics& report) {
  std::vector<std::string> names;
  for (const auto& [name, variable] : table.variables) names.push_back(name);
  for (const auto& [name, correlation] : table.correlations) {
    Diagnostics found;
    for (const auto& [key, variable] : {std::pair("first", correlation.first), std::pair("second", correlation.second)})
      if (!table.variables.count(variable))
        found.add(at_key(key), "there is no variable " + in_quotes(variable), suggestion(variable, names, "variables"));
    if (found.empty() && correlation.first == correlation.second)
      found.add(at_key("second"), "a variable is correlated with itself", "name two variables");
    add_at(dotted("reliability.correlations", name), found, document, report);
  }
}

void check_methods(const ReliabilityTable& table, const Document& document, Diagnostics& report) {
  for (const std::string& method : table.methods)
    if (report.sound("reliability.methods") &&
        std::find(reliability_methods.begin(), reliability_methods.end(), method) == reliability_methods.end())
      report.add(document.place("reliability.methods"), "there is no method " + in_quotes(method),
                 suggestion(method, reliability_methods, "methods"));
}

void check_wave(const DesignTables& tables, const Document& document, Diagnostics& report) {
  std::vector<std::string> names;
  for (const auto& [name, wave] : tables.waves) names.push_back(name);
  const std::string& asked = tables.reliability->wave;
  const std::string wave = random_wave(tables);
  if (wave.empty() && report.sound("waves") && report.sound("reliability.wave"))
    report.add(document.place("reliability.wave"),
               asked.empty() ? "which of the waves is the one of an occasion is not said"
                             : "there is no [waves." + asked + "]",
               asked.empty() ? "add wave, the name of one of [waves.NAME]: " + join(names)
                             : suggestion(asked, names, "waves"));
  if (!wave.empty() && tables.waves.at(wave).force)
    report.add(document.place(dotted("waves", wave) + ".force"),
               "the wave has a given force, and limit states are those of Goda's formulas",
               "remove force, and let a variable act on the factor force");
}

}  // namespace

double* number_at(DesignTables& tables, const std::string& key) {
  return found_at(tables, key).number;
}

std::string unit_at(const DesignTables& tables, const std::string& acts_on) {
  if (const RandomFactor* factor = find_factor(acts_on)) return factor->unit;
  DesignTables copy = tables;
  return found_at(copy, acts_on).unit;
}

std::vector<RandomVariable> complete_variables(const DesignTables& tables) {
  std::vector<RandomVariable> list;
  for (const auto& [name, given] : tables.reliability->variables) {
    RandomVariable variable = given;
    if (has_moments(variable.kind)) {
      if (!variable.mean) variable.mean = certain_value(tables, given.acts_on);
      if (!variable.deviation) variable.deviation = *variable.cov * std::abs(*variable.mean);
    }
    list.push_back(variable);
  }
  return list;
}

DesignTables at_means(const DesignTables& tables) {
  DesignTables means = tables;
  for (const auto& [name, variable] : tables.reliability->variables)
    if (double* number = number_at(means, variable.acts_on)) *number = middle_of(variable, *number);
  return means;
}

void check_reliability(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (!tables.reliability) {
    report.add(document.place(""), "the design has no [reliability]",
               "add [reliability] and [reliability.variables.NAME], see 'upbead reliability --help'");
    return;
  }
  check_methods(*tables.reliability, document, report);
  check_wave(tables, document, report);
  check_variables(tables, document, report);
  check_means(tables, document, report);
  check_correlations(*tables.reliability, document, report);
}

}  // namespace upbead
