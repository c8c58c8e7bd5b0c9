// The keys of slip and uplift node by node, in summaries of a run and of waves.
#pragma once

#include "output/output_schema.h"
#include "upbead/output/sliding_summary.h"

namespace upbead {

OutputSchema<ContactSummary> contact_outputs();

}  // namespace upbead
