// Random variables with their dependence, and the standard space: independent standard normal variables u of which the
// physical values x(u) are made [Nataf 1962; Ditlevsen and Madsen, Structural Reliability Methods (1996), ch. 7].
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "design/reliability_table.h"
#include "upbead/base/numbered_warning.h"

namespace upbead {

/// Each variable has a mean and a deviation where its kind has moments, and both ends where it has not.
struct RandomVariables {
  std::vector<std::string> names;
  std::vector<RandomVariable> list;
  std::vector<RandomCorrelation> correlations;  ///< of u, by names
};

class StandardSpace {
 public:
  /// Throws std::invalid_argument where the correlations cannot stand beside each other.
  explicit StandardSpace(const RandomVariables& variables);
  std::size_t size() const { return size_; }
  /// x(u), in the units of the variables.
  std::vector<double> physical(const std::vector<double>& u) const;

 private:
  struct Transformation;
  std::shared_ptr<const Transformation> transformation_;
  std::size_t size_;
};

/// Warns of variables that act on what is positive and reach 0 within 4 deviations in standard space (3e-5): formulas
/// have no meaning there.
NumberedWarnings not_positive(const RandomVariables& variables);

}  // namespace upbead
