// Times at which a case asks for readings: those that it lists, and equally spaced ones.
#pragma once

#include <vector>

#include "upbead/model/scene.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Times (s) at which fields are written, other than t = 0.
std::vector<double> times_of_fields(const Scene& scene);

/// Times at which steps must end, besides the kinks of the loads: those of fields, and those that [output] lists.
std::vector<double> times_to_look_at(const Scene& scene);

/// From 0 to the end at intervals of [output] every; empty without it.
std::vector<double> equal_times(const Scene& scene);

/// How far a time of a series may be from the time that was asked for (s).
double time_tolerance(const Scene& scene);

/// Fills in Solution::at_times, and Solution::dense where only straight lines are possible (schemes of order 2) and it
/// is not there.
void read_at_chosen_times(Solution& solution);

}  // namespace upbead
