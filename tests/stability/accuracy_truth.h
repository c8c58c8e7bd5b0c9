// Numbers of a run, compared with those on a far finer mesh.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "upbead/case/case_run.h"

namespace upbead::test {

/// A number of a run, its estimated error and its true error; both relative, but absolute for S.
struct JudgedNumber {
  double value = 0., told = 0., error = 0.;
  bool is_told = false;
};

struct AccuracyVerdict {
  std::string refused;  ///< why there is no answer
  JudgedNumber peak, history, slip, coupled, contact;
  /// Estimated error of the peak, with that by reflections of the far sides
  double peak_with_sides = 0.;
  double truth_peak = 0., truth_history = 0.;  ///< change of the truth by its last refinement
  int unknowns = 0, truth_unknowns = 0;
  std::string scheme;
  double seconds = 0., truth_seconds = 0.;
};

/// Solves a case with mesh.refine = "auto", and again on cells of a quarter of the size, at all corners of regions
/// another 8 times smaller, with a tenth of the error in time.
AccuracyVerdict judge_accuracy(const std::string& path);

}  // namespace upbead::test
