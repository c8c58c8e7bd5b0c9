// What came of one run of a study.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// What a run took over from the one before it, in the same process.
enum class Shared { nothing, mesh, solution };

struct RunResult {
  bool done = false;                          ///< false: it failed, and `message` says why
  std::vector<std::optional<double>> values;  ///< by Study::reads; none where the summary has none; empty if failed
  std::string message;
  Shared shared = Shared::nothing;
  double seconds = 0.;  ///< wall time
};

}  // namespace upbead
