// How near a bonded caisson comes to slip or lift at any node.
#pragma once

#include "run/sliding/uplift_course.h"
#include "upbead/base/history.h"
#include "upbead/dynamics/march.h"
#include "upbead/output/sliding_summary.h"

namespace upbead {

/// Adds what the forces of a series show: the last rows of its readings, of shear and normal force alternately, node by
/// node, as bonded() appends them; they are without the uplift.
void look_at_demand(const Interface& interface, const std::vector<UpliftLoad>& uplift, const Series& series,
                    BondedDemand& demand);

/// The demand on contact in a response of bonded(system, true), `system` with the interface; the forces may be wrong
/// by `margin` of their largest value over all nodes.
BondedDemand contact_demand(const Interface& interface, const std::vector<UpliftLoad>& uplift, const Response& response,
                            double margin);

}  // namespace upbead
