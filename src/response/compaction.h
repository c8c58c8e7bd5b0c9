// Results of cyclic shear in soils that become denser.
#pragma once

#include <vector>

#include "fem/soil_laws.h"
#include "fem/unknowns.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/dynamics/march.h"
#include "upbead/response/findings.h"

namespace upbead {

/// One result for each region with such points, at the end of a march; the points of a cell stand for equal shares of
/// its area.
std::vector<CompactedSoil> compacted_soils(const Space& space, const Unknowns& unknowns, const CompactingPoints& points,
                                           const State& end);

/// Warnings liquefied: soil has lost nearly all of its mean effective stress; beyond_compaction: amplitudes of shear
/// strain are larger than those at which the law was measured.
NumberedWarnings compaction_warnings(const std::vector<CompactedSoil>& soils);

}  // namespace upbead
