// The histories of a case's loads.
#pragma once

#include <string>

#include "case_schema.h"

namespace upbead {

/// Fills `load` from the file `path` (CSV or HDF5), in a run until `end` (s): the time is the column whose header says
/// so, the value the first other one that is no counter. Throws InputError: the file as such, fewer than two columns or
/// rows, times that do not ascend from 0, all zero. `place`: the key that names the file.
void read_history(const std::string& path, const Place& place, double end, Load& load);

/// U(t) of a prescribed uplift from such a file; it may be zero, but not negative. Throws InputError as above.
TimeFunction read_uplift(const std::string& path, const Place& place);

}  // namespace upbead
