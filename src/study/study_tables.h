// The keys of the study file, and the tables that they fill.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/schema.h"
#include "literal.h"

namespace upbead {

/// How the varied keys combine.
enum class Sampling {
  grid,    ///< every value of each key with every value of all others
  paired,  ///< the first values together, the second ones together, and so on
  random,  ///< n independent draws
};

enum class Spacing { linear, log };
enum class DrawnBy { uniform, log_uniform, normal, log_normal };

/// A table [vary.KEY].
struct VaryTable {
  std::vector<Literal> values;
  std::optional<double> from, to;
  std::optional<int> n;
  Spacing spacing = Spacing::linear;
  std::optional<DrawnBy> distribution;
  std::optional<double> low, high, mean, cov;
};

/// A table [follow.KEY]: that key is `factor` times the one named here.
struct FollowTable {
  std::string key;
  double factor = 1.;
};

struct StudyTables {
  std::string title;
  std::string one_case;
  std::vector<std::string> cases;
  Sampling sample = Sampling::grid;
  std::optional<int> n;
  int seed = 1;
  std::vector<std::string> read;
  std::map<std::string, Literal> set;
  std::map<std::string, VaryTable> vary;
  std::map<std::string, FollowTable> follow;
};

TableSchema<StudyTables> study_schema();

/// What is read where a study does not say.
const std::vector<std::string>& default_reads();

}  // namespace upbead
