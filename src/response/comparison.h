// How far a computed history lies from a measured one.
#pragma once

#include <string>
#include <vector>

#include "upbead/response/findings.h"

namespace upbead {

/// `measured` at `time` (ascending) against `computed` at `computed_time` (ascending), linear between. Throws
/// std::invalid_argument where they share fewer than two times, or the measured one is zero there.
Comparison compare(const std::vector<double>& time, const std::vector<double>& measured,
                   const std::vector<double>& computed_time, const std::vector<double>& computed);

}  // namespace upbead
