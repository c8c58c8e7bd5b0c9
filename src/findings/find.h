// Findings put together: checks, warnings, the verdict, the keys of summary.json.
#pragma once

#include <vector>

#include "findings/finding.h"
#include "upbead/findings/find.h"

namespace upbead {

/// The checks of all findings. Without a state at rest those of a march are not checked.
Checks checks_of(const Scene& scene, const Summary& summary, const std::vector<Finding>& also = {});

/// Warnings routes_differ: a check by formulas holds and the same by dynamics does not, or the other way round.
NumberedWarnings route_warnings(const Checks& checks);

/// The keys of the findings of the scene and of `also`.
OutputSchema<Summary> keys_of(const std::vector<Finding>& also);

}  // namespace upbead
