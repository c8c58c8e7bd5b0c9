// Text for the terminal.
#pragma once

#include <string>
#include <vector>

#include "case/records/measured.h"
#include "output/output_schema.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// What will be solved, in four lines: title, mesh and regions, loads, the way in time.
std::string brief(const Case& input, const Simulation& simulation);

/// What `explain` says, as JSON, and its keys; `told`: what may be wrong and needs no solution.
Json explanation(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& measured,
                 const NumberedWarnings& told = {});
std::vector<OutputRow> rows_of_explain();

/// All of it: mesh, unknowns, regions with their flow and why, loads with their arms, what is skipped.
std::string details(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& measured);

/// The results in one screen: verdict, checks that fail or have a limit, what people came for.
std::string brief(const Summary& summary);

/// All results: what every finding has to say, checks, times.
std::string details(const Summary& summary);

}  // namespace upbead
