// What is said of a solution: a function of it and of nothing else.
#pragma once

#include <functional>
#include <vector>

#include "upbead/run/simulation.h"

namespace upbead {

struct Finding;

/// All findings of the solution, and those of `also`. Errors that the scene asks for are found by solving it in other
/// ways; `progress` is called meanwhile. Throws NumericsError as a march does.
Summary find(const Solution& solution, const std::function<void(double)>& progress = {},
             const std::vector<Finding>& also = {});

/// The solution with all its findings, and the rows of its history that they were read from.
Run run_of(Solution solution, const std::function<void(double)>& progress = {}, const std::vector<Finding>& also = {});

/// The warnings of a scene that are known without solving it: docs/warnings.md.
NumberedWarnings warnings(const Simulation& simulation, const std::vector<Finding>& also = {});

/// What is skipped in a scene and why, with the numbers; `reduced`: whether a reduced model solves it.
std::vector<Skipped> skipped(const Simulation& simulation, bool reduced, const std::vector<Finding>& also = {});

}  // namespace upbead
