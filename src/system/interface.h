// Systems made from one with an interface, in which the bodies may move relative to each other in fewer ways, or in
// none.
#pragma once

#include "upbead/system/system.h"

namespace upbead {

/// Group of the interface's readings: the last readings of a system, which are lost with its interface.
inline const std::string interface_group = "interface";

/// The bodies bonded: the system without the unknowns of its interface. With `forces` it also has readings of the
/// forces at all nodes: alternately shear_force T_i (N/m), on the lower body, landward, and normal_force, the change
/// of the effective N_i (N/m).
System bonded(const System& system, bool forces = false);

/// The upper body may slip as a whole: all nodes have the same slip s (m, landward), which is free, and no opening. s
/// is the last free unknown. Its residual is -F_T, with F_T the shear force on the lower body; no load acts on s yet.
System with_rigid_slip(const System& system);

/// The upper body may slip and open as a whole: the same with an interface of one node, which carries all forces.
System with_one_node(const System& system);

}  // namespace upbead
