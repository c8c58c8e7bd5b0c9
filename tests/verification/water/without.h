// Removes unknowns from a compiled system.
#pragma once

#include <vector>

#include "scenes.h"

namespace upbead::test {

/// The system in which these unknowns stay zero: their rows and columns are removed. None of them may be prescribed.
System without(const System& system, const std::vector<int>& gone);

/// Unknowns of one component (0, 1: u; 4: phi) on the whole mesh; coordinates of rigid bodies are none of them.
std::vector<int> unknowns_of(const Compiled& compiled, unsigned component);

}  // namespace upbead::test
