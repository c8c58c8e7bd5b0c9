// The numbers by which a section is approved: the S for design, and each check with demand, capacity and margin.
#pragma once

#include "upbead/model/scene.h"
#include "upbead/output/summary.h"

namespace upbead {

/// The S by the measure with the most mechanics that the run has: friction node by node, else a caisson that slips as
/// a whole on the ground that it shakes, else the larger of eq. (4) on F_T(t) with and without the vertical motion.
DesignSliding design_sliding(const SlidingSummary& sliding, const std::optional<ContactSummary>& contact,
                             const std::optional<ResidualSummary>& residual);

/// Sliding, friction, pressure of heel and toe, overturning: each check whose demand is in the summary; then those of
/// its loads by waves, by formulas.
Checks checks_of(const Scene& scene, const Summary& summary);

/// Warnings routes_differ: a check by formulas holds and the same by dynamics does not, or the other way round.
NumberedWarnings route_warnings(const Checks& checks);

/// Draws checks, and the warnings that follow from them, anew: to be called whenever one of their numbers has changed.
void judge(const Scene& scene, Summary& summary);

/// Whether the response is that of a caisson whose friction was followed node by node; else it is bonded.
bool is_solved_with_friction(const Summary& summary);

}  // namespace upbead
