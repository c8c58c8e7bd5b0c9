// By how much each number of a case is multiplied.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "../case_schema.h"
#include "case/scale.h"

namespace upbead {

/// Ratios that a person gives by key.
class Ratios {
 public:
  /// Throws InputError for a text that is not KEY=VALUE with a finite VALUE.
  explicit Ratios(const std::vector<std::string>& texts);
  /// The ratio of the key at a dotted path, or nullptr.
  const double* find(const std::string& path);
  /// How the ratio of a path was written, as a place for messages.
  Place place(const std::string& path) const;
  /// Throws InputError where a ratio names none of the keys that find() was asked for.
  void require_all_used() const;

 private:
  std::map<std::string, double> ratio_;
  std::map<std::string, std::string> text_;
  std::set<std::string> asked_, used_;
};

/// Multiplies every number of the tables; the keys that keep a number with a dimension go to `kept`. The mesh's
/// parameters are left alone: their units stand in the .geo. Throws InputError.
void scale_numbers(CaseTables& tables, const ScaleOptions& options, Ratios& ratios, std::vector<std::string>& kept);

/// The unit of a load's history: it follows from the load's kind.
std::string history_unit(const Load& load);

}  // namespace upbead
