// Solves one case by "auto" and by sdirk4: if sdirk4 solves it, "auto" must solve it.
#pragma once

#include <string>

#include "judge.h"

namespace upbead::test {

struct BothWays {
  /// Failed: sdirk4 solves it and "auto" does not. Refused: neither does. Passed: "auto" does.
  Verdict::Kind kind = Verdict::Kind::passed;
  std::string why;
  std::string sdirk4;       ///< why sdirk4 refuses the case; "" if it does not
  std::string way;          ///< that "auto" has taken
  int steps_of_ladder = 0;  ///< ways that "auto" has tried
  double difference = -1.;  ///< of the peaks of |F_T|, over the larger one; -1 if there is nothing to compare
};

/// Solves the case at that path, ignoring its scheme, with its steps divided by `finer`.
BothWays solve_both_ways(const std::string& path, double finer);

}  // namespace upbead::test
