// The keys of slip by formulas on F_T(t) and as a block on the moving ground.
#pragma once

#include "output/output_schema.h"
#include "upbead/output/sliding_summary.h"

namespace upbead {

OutputSchema<SlidingSummary> sliding_outputs();

}  // namespace upbead
