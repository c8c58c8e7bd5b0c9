// Solves one case as the program chooses and by sdirk4: what sdirk4 answers, "auto" must answer.
#pragma once

#include <string>

#include "judge.h"

namespace upbead::test {

struct BothWays {
  /// Failed: sdirk4 answers and "auto" does not. Refused: neither does. Passed: "auto" answers.
  Verdict::Kind kind = Verdict::Kind::passed;
  std::string why;
  std::string sdirk4;       ///< why it does not answer; "" where it does
  std::string way;          ///< that "auto" has taken
  int steps_of_ladder = 0;  ///< ways that "auto" has tried
  double difference = -1.;  ///< of the peaks of |F_T|, over the larger one; -1 where there is none to compare
};

/// The case at that path, whatever scheme it names, its steps divided by `finer`.
BothWays solve_both_ways(const std::string& path, double finer);

}  // namespace upbead::test
