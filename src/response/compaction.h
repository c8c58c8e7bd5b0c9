// What cycles of shear made of soils that pack denser.
#pragma once

#include <vector>

#include "fem/soil_laws.h"
#include "fem/unknowns.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/dynamics/march.h"
#include "upbead/response/findings.h"

namespace upbead {

/// One for each region with such points, at the end of a march; the points of a cell stand for equal parts of its area.
std::vector<CompactedSoil> compacted_soils(const Space& space, const Unknowns& unknowns, const CompactingPoints& points,
                                           const State& end);

/// liquefied: soil has lost nearly all of its mean effective stress; beyond_compaction: amplitudes of shear strain
/// larger than those that the law was measured at.
NumberedWarnings compaction_warnings(const std::vector<CompactedSoil>& soils);

}  // namespace upbead
