// The values of varied keys in each run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study_tables.h"

namespace upbead {

/// A varied key with all that is said of it.
struct Axis {
  std::string key;
  VaryTable vary;
};

/// The values of a list or a range, in their order. The ends of a range are met exactly.
std::vector<Literal> values_of(const VaryTable& vary);

/// The value of a key in draw number `draw`: it depends on nothing else than these and the seed, so that more draws or
/// other keys leave it as it is.
Literal drawn_value(const Axis& axis, std::uint64_t seed, int draw);

/// How many runs the axes make; of a grid the product, which may be too many for an int.
double number_of_runs(const StudyTables& study, const std::vector<Axis>& axes);

/// The values of all axes in each run, of a study without mistakes.
class Sampler {
 public:
  /// Both must outlive it.
  Sampler(const StudyTables& study, const std::vector<Axis>& axes);
  int n_runs() const;
  /// In a grid the last axis runs fastest.
  std::vector<Literal> values(int run) const;

 private:
  const StudyTables& study_;
  const std::vector<Axis>& axes_;
  std::vector<std::vector<Literal>> lists_;  ///< of axes that are no distributions
};

}  // namespace upbead
