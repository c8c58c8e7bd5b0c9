// The keys of [reliability], and the tables that they fill: what is random, by which methods, for how long.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/schema.h"
#include "input/values.h"

namespace upbead {

struct DesignTables;
class Document;

/// Names, one at least: ["sliding", "overturning"].
struct NameList : std::vector<std::string> {
  using vector::vector;
};

Diagnostics read_value(const Node& node, const KeyInfo& key, NameList& value);

enum class RandomKind { normal, lognormal, gumbel, weibull, uniform, triangular };

/// The word of a file for it.
std::string word_of(RandomKind kind);

/// [reliability.variables.NAME]: a random variable, for one occasion. Mean and deviation are those of the whole
/// distribution, before its ends are cut.
struct RandomVariable {
  std::string acts_on;  ///< a key of the design, or a factor of `random_factors`
  RandomKind kind = RandomKind::normal;
  std::optional<double> mean;            ///< none: the number of the design; of a factor 1
  std::optional<double> cov, deviation;  ///< one of them, where the kind has moments
  std::optional<double> location;        ///< least value of weibull and lognormal; none: 0
  std::optional<double> mode;            ///< of triangular
  std::optional<double> low, high;       ///< ends of uniform and triangular; where the others are cut
};

/// [reliability.correlations.NAME]: of the standard normal variables behind two variables (normal copula).
struct RandomCorrelation {
  std::string first, second;
  double coefficient = 0.;
};

/// [reliability.system.NAME]: it fails where any, or where all, of these fail.
struct SystemNode {
  std::optional<NameList> any, all;  ///< one of them: limit states and other systems
};

/// [reliability.targets]: what codes ask for; none: that of `assumed_targets`.
struct ReliabilityTargets {
  std::optional<double> exceed_0_1, exceed_0_3, exceed_1_0;  ///< of S over 50 years
  std::optional<double> expected_sliding;                    ///< m
  std::optional<double> pianc_life;                          ///< probability
  std::optional<double> eurocode_year, eurocode_life;        ///< beta
};

/// Known from memory, and not looked up in the codes but for expected_sliding: Japanese standard of 2007, importance
/// "normal" (0.30, 0.10, 0.05); Shimosako and Takahashi (1998) (0.30 m); PIANC WG 28, ultimate limit state, safety
/// class "normal" (0.05); EN 1990 Annex B, class RC2 (4.7 in a year, 3.8 in 50 years).
extern const ReliabilityTargets assumed_targets;

/// [reliability].
struct ReliabilityTable {
  std::string wave;  ///< name of [waves.NAME]; "": the only one
  NameList methods{"form", "sorm", "importance", "subset"};
  double years = 50.;
  double occasions_per_year = 1.;
  std::optional<double> target;  ///< least beta of the life
  bool dynamics = false;         ///< limit states by F_T of [dynamics], too; also where a variable acts on its soil
  int seed = 1;
  int samples = 20000;
  int plain_samples = 1000000;
  std::map<std::string, RandomVariable> variables;
  std::map<std::string, RandomCorrelation> correlations;
  std::map<std::string, SystemNode> system;
  ReliabilityTargets targets;
};

/// A factor that a variable may act on, with its unit, and its value where it is certain.
struct RandomFactor {
  const char *name, *unit;
  double certain;
};
extern const std::vector<RandomFactor> random_factors;
/// The factor of that name, or nullptr.
const RandomFactor* find_factor(const std::string& name);

/// The methods in their order: form, sorm, importance, subset, plain.
extern const std::vector<std::string> reliability_methods;

TableSchema<ReliabilityTable> reliability_schema();

/// The wave's name: the one given, or the only one of the design; "" where that is open.
std::string random_wave(const DesignTables& tables);

/// The number of a key in the tables, where it is given and a variable may act on it: one of section, fluid, duration,
/// of the wave, limits.sliding and limits.base_pressure, and a key of [dynamics] soil.
double* number_at(DesignTables& tables, const std::string& key);

/// The unit of what a variable acts on; "" for none.
std::string unit_at(const DesignTables& tables, const std::string& acts_on);
/// The number that the design has where a variable acts; none: it cannot act there.
std::optional<double> certain_value(const DesignTables& tables, const std::string& acts_on);

/// Variables with their means and deviations, in the order of their names, and correlations among them.
std::vector<RandomVariable> complete_variables(const DesignTables& tables);

/// The tables with the mean of every variable in its place, or the middle of one that is given by its ends.
DesignTables at_means(const DesignTables& tables);

/// Checks what `reliability` needs of the variables: what they act on, moments, ends, correlations.
void check_reliability(const DesignTables& tables, const Document& document, Diagnostics& report);

}  // namespace upbead
