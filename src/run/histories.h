// The datasets of results.h5.
#pragma once

#include <string>
#include <vector>

#include "output/result_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Histories of all readings, by the names of /history, and of what stands on the ground. `ends`: of the scene.
std::vector<Dataset> histories(const Simulation& simulation, const Series& ends);

/// The same at the times that [output] lists, as a table: a row for each time, names with their units as a header.
std::string times_csv(const Run& run);

/// The same names and units, without times.
std::vector<Dataset> names_of_histories(const Simulation& simulation);

/// All that is no history of the steps: histories at chosen times (/at_times, /dense), the bottom's stress, the nodes
/// of an interface, a caisson that slips as a whole.
std::vector<Dataset> tables(const Run& run);

}  // namespace upbead
