// A system divided among processes, and its state joined again.
#pragma once

#include "upbead/algebra/layout.h"
#include "upbead/system/system.h"

namespace upbead {

/// Restricts a system to the unknowns that this process needs, and returns for each unknown its index there, or -1.
///
/// Before, M, C, K and the radiation are those of this process's own cells, and their sums over all processes are
/// those of the whole system; loads and readings are whole. After, the process holds the unknowns that its cells
/// touch, `on_all`, and the prescribed ones; they keep their order. Loads and readings are divided too: their sum over
/// all processes is the whole. So, if each process knows x in its unknowns, M x, b'x, a reading and every energy are
/// sums over processes, and only solves need more communication. All processes must call it together. Throws
/// NumericsError where their systems differ in size.
std::vector<int> divide(System& system, const std::vector<int>& on_all, std::shared_ptr<const Processes> processes);

/// How the unknowns of a system lie on its processes.
Layout layout_of(const System& system);
/// Values of the unknowns of this process, from parts whose sum over processes they are.
Vector values_of(const System& system, Vector parts);
/// Whether this process counts for the prescribed unknowns, which all hold: the first one does.
bool counts_for_prescribed(const System& system);
/// Unknowns of the whole system.
int whole_size(const System& system);

/// The state of the whole system, from those of all parts. All processes must call it together, and each gets it.
State joined(const System& part, const State& state);
/// This process's part of a state of the whole system. All processes must call it together.
State restricted(const System& part, const State& whole);

}  // namespace upbead
