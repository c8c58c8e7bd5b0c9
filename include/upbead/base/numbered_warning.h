// A result that may be wrong although nothing failed: an assumption that does not hold, with the number that says so.
#pragma once

#include <string>
#include <vector>

namespace upbead {

struct NumberedWarning {
  std::string name;   ///< such as "step_too_coarse"; docs/warnings.md has one row for each
  double value = 0.;  ///< that decided
  double limit = 0.;  ///< that it passes
  std::string unit;   ///< of both; "1" where they have none
  std::string text;   ///< for people: what is wrong, with the number, and what to do
};

using NumberedWarnings = std::vector<NumberedWarning>;

/// Puts a list, of warnings for instance, behind another.
template <class Item>
void append(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace upbead
