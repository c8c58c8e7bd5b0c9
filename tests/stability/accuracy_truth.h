// What a run gives, and what a far finer mesh says to it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/case_run.h"

namespace upbead::test {

/// A number of a run: what is told of its error, and the error; both relative but for S.
struct JudgedNumber {
  double value = 0., told = 0., error = 0.;
  bool is_told = false;
};

struct AccuracyVerdict {
  std::string refused;  ///< why there is no answer
  JudgedNumber peak, history, slip, coupled, contact;
  double peak_with_sides = 0.;                 ///< what is told of the peak with what the far sides send back
  double truth_peak = 0., truth_history = 0.;  ///< by how much the truth itself moved when it was last refined
  int unknowns = 0, truth_unknowns = 0;
  std::string scheme;
  double seconds = 0., truth_seconds = 0.;
};

/// Solves a case with mesh.refine = "auto", and the same on cells a quarter as large, 8 times smaller at all corners
/// of regions besides, a tenth as wrong in time.
AccuracyVerdict judge_accuracy(const std::string& path);

}  // namespace upbead::test
