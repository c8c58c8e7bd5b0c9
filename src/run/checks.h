// The numbers by which a section is approved: the S for design, and each check with demand, capacity and margin.
#pragma once

#include <vector>

#include "upbead/model/scene.h"
#include "upbead/output/summary.h"

namespace upbead {

/// The S by the measure with the most mechanics that the run has: friction node by node, else a caisson that slips as
/// a whole on the ground that it shakes, else the larger of eq. (4) on F_T(t) with and without the vertical motion.
DesignSliding design_sliding(const SlidingSummary& sliding, const std::optional<ContactSummary>& contact,
                             const std::optional<ResidualSummary>& residual);

/// Sliding, friction, pressure of heel and toe, overturning: each check whose demand is in the summary.
std::vector<Check> checks_of(const Scene& scene, const Summary& summary);

}  // namespace upbead
