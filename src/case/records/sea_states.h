// The file of a record of sea states.
#pragma once

#include <string>
#include <vector>

#include "case/records/record_layout.h"
#include "upbead/base/error.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

/// Reads a CSV file with the columns significant_height (m), period (s), waves, and, where given, angle (degrees) and
/// water_level (m), in any order. Units in the header are converted; a counter is left out and added to `notes`.
/// Throws InputError with every mistake; a file that cannot be read is a mistake at `place`.
std::vector<SeaState> read_sea_states(const std::string& path, const Place& place, RecordNotes& notes);

}  // namespace upbead
