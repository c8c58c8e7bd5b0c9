// The datasets of results.h5.
#pragma once

#include <string>
#include <vector>

#include "dynamics/trajectory.h"
#include "output/result_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// What was solved at any time; the solution must outlive it.
Trajectory trajectory_of(const Solution& solution);

/// Histories of all readings, by the names of /history, and those of the base (effective_base.h). `ends`: of the
/// scene; `contact`: what nodes did that slip and open.
std::vector<Dataset> histories(const Simulation& simulation, const Series& ends,
                               const std::optional<ContactSolution>& contact = std::nullopt);

/// The same at the times that [output] lists, as a table: one row for each time; the header has names with units.
std::string times_csv(const Run& run);

/// The same names and units, without times.
std::vector<Dataset> names_of_histories(const Simulation& simulation);

/// All datasets: /history, histories at chosen times (/at_times, /dense), stresses of the bottom at the times of
/// /history, nodes of an interface, the caisson that slips as a whole.
std::vector<Dataset> tables(const Run& run);

}  // namespace upbead
