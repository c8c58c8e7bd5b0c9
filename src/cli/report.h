// Text for the terminal.
#pragma once

#include <string>

#include "case/records/measured.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// What will be solved: mesh, unknowns, regions with their flow and why, loads with their arms, what is skipped.
std::string describe(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& measured);

/// The results: peaks, ratio, checks, times.
std::string describe(const Run& run);

}  // namespace upbead
