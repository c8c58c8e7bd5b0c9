// What people read of the sliding.
#pragma once

#include <string>

#include "upbead/output/summary.h"

namespace upbead {

/// Lines with F_Smax, S by every measure, and tau_0.
std::string describe(const SlidingSummary& sliding);

}  // namespace upbead
