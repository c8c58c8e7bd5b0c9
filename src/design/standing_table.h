// The standing wave of a section as a row of a table, and what exceeds its limits.
#pragma once

#include <string>
#include <vector>

#include "upbead/model/scene.h"
#include "upbead/waves/standing_stability.h"

namespace upbead {

/// Cells of a table, in m, kN/m and kPa; "!" marks a value beyond a limit.
std::vector<std::string> standing_head();
std::vector<std::string> standing_row(const std::string& name, const StandingAnswer& answer, const Limits& limits);

/// The heel pressure in kPa, with "!" where it exceeds the limit; "none" where the resultant leaves the base.
std::string judged_heel(const Stability& stability, const Limits& limits);

/// Whether a limit is given and exceeded; a pressure that does not exist exceeds every limit.
bool too_much_pressure(const Stability& stability, const Limits& limits);
bool overturns_too_easily(const Stability& stability, const Limits& limits);

}  // namespace upbead
