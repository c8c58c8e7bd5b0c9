// Times that the steps of a case meet, besides the kinks of its loads.
#pragma once

#include <vector>

#include "upbead/model/scene.h"

namespace upbead {

/// Times (s) at which fields are written, other than t = 0.
std::vector<double> times_of_fields(const Scene& scene);

/// Times at which steps must end, besides the kinks of the loads: those of fields, and those that [output] lists.
std::vector<double> times_to_look_at(const Scene& scene);

}  // namespace upbead
