// The keys of the study file, the tables that they fill, and the values that follow for each run.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "expected/sobol_sample.h"
#include "input/schema.h"
#include "input/values.h"
#include "study/study.h"
#include "upbead/input/document.h"
#include "upbead/input/report_head.h"

namespace upbead {

/// A number, a word, true or false, or a list of those.
struct Literal {
  std::string toml;  ///< as TOML; a whole number without a point, so that a key for whole numbers takes it too
  bool is_number = false;
  double number = 0.;
};

Literal literal(double number);

Diagnostics read_value(const Node& node, const KeyInfo& key, Literal& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Literal>& value);
/// Reads values by dotted key; tables within the table lengthen the key.
Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, Literal>& value);

std::string type_text(const KeyInfo& key, const Literal*);
std::string type_text(const KeyInfo& key, const std::vector<Literal>*);
std::string type_text(const KeyInfo& key, const std::map<std::string, Literal>*);
inline ValueShape shape_of(const KeyInfo&, const Literal*) {
  return ValueShape::anything;
}
inline ValueShape shape_of(const KeyInfo&, const std::vector<Literal>*) {
  return ValueShape::list;
}
inline ValueShape shape_of(const KeyInfo&, const std::map<std::string, Literal>*) {
  return ValueShape::table;
}

std::string print_value(const KeyInfo& key, const Literal& value);
std::string print_value(const KeyInfo& key, const std::vector<Literal>& value);
std::string print_value(const KeyInfo& key, const std::map<std::string, Literal>& value);

/// Nothing to visit: these types have no key with a unit.
inline void visit_value(const KeyInfo&, const std::string&, std::vector<Literal>&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, std::map<std::string, Literal>&, const NumberVisitor&) {}

/// How the varied keys combine.
enum class Sampling {
  grid,    ///< every value of each key with every value of all others
  paired,  ///< the first values together, the second ones together, and so on
  random,  ///< n independent draws
  sobol,   ///< n (d + 2) runs for the Sobol indices of d keys, see expected/sobol_sample.h
};

inline bool has_draws(Sampling sampling) {
  return sampling == Sampling::random || sampling == Sampling::sobol;
}

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
  ReportHead report;
  std::string one_case;
  std::vector<std::string> cases;
  Sampling sample = Sampling::grid;
  std::optional<int> n;
  int seed = 1;
  std::vector<std::string> read;
  bool summaries = false;
  StudyShare share = StudyShare::all;
  std::map<std::string, Literal> set;
  std::map<std::string, VaryTable> vary;
  std::map<std::string, FollowTable> follow;
};

TableSchema<StudyTables> study_schema();

/// The numbers that are read where a study does not name any.
const std::vector<std::string>& default_reads();

/// A varied key and its table.
struct Axis {
  std::string key;
  VaryTable vary;
};

/// The tables [vary] in the order of the file.
std::vector<Axis> axes_of(const StudyTables& tables, const Document& document);

/// The values of a list or a range, in their order. The ends of a range are met exactly.
std::vector<Literal> values_of(const VaryTable& vary);

/// The value of an axis at a probability in (0, 1): a quantile, or one of its values, with equal chances.
Literal value_at(const Axis& axis, double probability);

/// The value of a key in draw number `draw`: it depends only on the axis, the seed and the number, so that more draws
/// or other keys do not change it.
Literal drawn_value(const Axis& axis, std::uint64_t seed, int draw);

/// How many runs the axes make; for a grid the product, which may be too large for an int.
double number_of_runs(const StudyTables& study, const std::vector<Axis>& axes);

/// The values of all axes in each run, for a study without mistakes.
class Sampler {
 public:
  /// Study and axes must outlive the object.
  Sampler(const StudyTables& study, const std::vector<Axis>& axes);
  int n_runs() const;
  /// In a grid the last axis runs fastest.
  std::vector<Literal> values(int run) const;
  /// Of a Sobol sample, as in StudyRun; 0 and "" in others.
  int point(int run) const;
  std::string matrix(int run) const;

 private:
  const StudyTables& study_;
  const std::vector<Axis>& axes_;
  std::vector<std::vector<Literal>> lists_;  ///< of axes without a distribution
  std::optional<SobolSample> sobol_;
};

/// Reports mistakes in the study itself, without its cases. `axes`: in the order of the file.
void check_study(const StudyTables& study, const std::vector<Axis>& axes, const Document& document,
                 Diagnostics& report);

/// Throws InputError where a key is written without quotes, [vary.time.end]: what the schema would report is no help.
void require_quoted_keys(const Document& document);

}  // namespace upbead
