// Records of strong motion as PEER's database gives them: four lines of head, then numbers at equal steps, several a
// line.
#pragma once

#include <optional>
#include <string_view>

#include "base/csv.h"

namespace upbead {

/// The columns "time" and "acceleration", "velocity" or "displacement"; none where the text is no such record, whose
/// fourth line has NPTS and DT. Throws InputError where it is one, but without unit or with another number of samples
/// than it tells.
std::optional<CsvTable> read_strong_motion(std::string_view text, const std::string& path);

}  // namespace upbead
