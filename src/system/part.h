// A system divided among processes.
#pragma once

#include "upbead/system/system.h"

namespace upbead {

/// Restricts a system to what this process needs of it, and returns for each unknown its index there, or -1.
///
/// Before, M, C, K and the radiation are those of this process's own cells, so that their sums over all processes are
/// the whole; loads and readings are whole. After, the process holds the unknowns that its cells touch, all that those
/// of several processes touch, and `on_all` and the prescribed ones; they keep their order. Loads and readings are
/// divided too: the sum over all processes is the whole. So with x known to all that hold it, M x, b'x, a reading and
/// every energy are sums over processes, and nothing but solves needs the others. All processes call it alike. Throws
/// NumericsError where their systems are not of one size.
std::vector<int> divide(System& system, const std::vector<int>& on_all, std::shared_ptr<const Processes> processes);

}  // namespace upbead
