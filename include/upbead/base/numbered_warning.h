// A warning: a result may be wrong although nothing failed, because an assumption does not hold. It has the number that
// shows this.
#pragma once

#include <string>
#include <vector>

namespace upbead {

struct NumberedWarning {
  std::string name;    ///< such as "step_too_coarse"; docs/warnings.md has one row for each
  double value = 0.;   ///< the number that decided
  double limit = 0.;   ///< the limit that the number passes
  std::string unit;    ///< of both; "1" where they have none, "" where there is no such number
  std::string what;    ///< what is wrong, with the number
  std::string cure;    ///< what to do, as a command to the user
  bool voids = false;  ///< whether no verdict may be drawn as long as it stands

  std::string text() const { return cure.empty() ? what : what + "; " + cure; }
};

using NumberedWarnings = std::vector<NumberedWarning>;

/// Appends one list, of warnings for instance, to another.
template <class Item>
void append(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace upbead
