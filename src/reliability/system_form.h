// A system of limit states, each of them as flat at its design point: FORM for fault trees.
#pragma once

#include <vector>

#include "reliability/methods.h"

namespace upbead {

/// Events that fail together; it fails where all events of any set fail. By place in a list of design points.
using CutSets = std::vector<std::vector<std::size_t>>;

/// All sets of one event each, in series: probability_of_any(). Others: the sum over sets by inclusion and exclusion of
/// Phi_n(-beta; R), R = alpha_i . alpha_k (Hohenbichler and Rackwitz 1983), within Ditlevsen's (1979) bounds; where it
/// was not, why_not says so beside the bound. None where an event has no design point, or there are more than ten sets.
MethodAnswer by_system_form(const std::vector<DesignPointSearch>& events, const CutSets& sets);

/// For each set the point nearest to the origin at which all its flat limit states fail, the nearest set first. Sets
/// with an event without a design point are left out.
std::vector<DesignPoint> design_points(const std::vector<DesignPointSearch>& events, const CutSets& sets);

}  // namespace upbead
