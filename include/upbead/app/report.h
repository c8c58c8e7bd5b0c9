// What people read on the terminal.
#pragma once

#include <string>

#include "upbead/app/pipeline.h"

namespace upbead {

/// What will be solved: mesh, unknowns, regions with their flow and why, loads with their arms, what is skipped.
std::string describe(const Case& input, const CompiledCase& scene);

/// What came out: peaks, ratio, checks, times.
std::string describe(const Run& run);

/// Warnings, one line each: "warning: NAME: text".
std::string describe(const NumberedWarnings& warnings);

/// A number with its unit, in the prefix that reads best: "3.01 kN/m"; milli for metres only, for mN reads as MN. What
/// is below 1e-9 of `peak` is round-off and prints as 0.
std::string with_unit(double value, const std::string& unit, double peak = 0.);

}  // namespace upbead
