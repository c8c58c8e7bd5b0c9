// How near a glued caisson comes to slipping or lifting.
#pragma once

#include <string>

#include "upbead/dynamics/march.h"
#include "upbead/output/summary.h"

namespace upbead {

/// Of a response of glued(system, true), `system` with the interface; the forces may be wrong by `margin` of their
/// largest value over all nodes.
GluedDemand contact_demand(const System& system, const Response& response, double margin);

/// Why the glued solution obeys the law of contact, with the numbers.
std::string why_glued(const ContactSummary& contact);

}  // namespace upbead
