// Unknowns on a curve of the mesh, and constraining them to be equal.
#pragma once

#include <string>
#include <vector>

#include "scenes.h"

namespace upbead::test {

/// Unknowns of one component (0, 1: u; 4: phi) on the named curve; constrained unknowns are left out.
std::vector<int> unknowns_on(const Compiled& compiled, const std::string& curve, unsigned component);

/// The system in which all unknowns of `group` are one (its first): a rigid smooth plate. M, C, K, loads and readings
/// change by the same congruence, so symmetry is kept. Needs a system without blocks and without prescribed unknowns.
System tied(const System& system, const std::vector<int>& group);

}  // namespace upbead::test
