// Times at which a case wants to be told readings: those that it lists, and equal ones.
#pragma once

#include <vector>

#include "upbead/model/scene.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Times (s) at which fields are written, other than t = 0.
std::vector<double> times_of_fields(const Scene& scene);

/// Times that steps meet, besides the kinks of the loads: of fields, and those that [output] lists.
std::vector<double> times_to_look_at(const Scene& scene);

/// From 0 to the end every [output] every; empty without.
std::vector<double> equal_times(const Scene& scene);

/// How far a time of a series may lie from one that was asked for (s).
double time_tolerance(const Scene& scene);

/// Fills in Run::at_times, and Run::dense where nothing more accurate than straight lines has: of schemes of order 2.
void read_at_chosen_times(Run& run);

}  // namespace upbead
