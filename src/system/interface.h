// What a system with an interface becomes where the bodies may move relative to each other in fewer ways, or in none.
#pragma once

#include "upbead/system/system.h"

namespace upbead {

/// The readings of an interface. They are the last ones of a system, and are lost with it.
inline const std::string interface_group = "interface";

/// The bodies glued together: the system without the unknowns of its interface. With `forces` it has readings of the
/// forces at all nodes besides: in turns shear_force T_i (N/m), on the lower body, landward, and normal_force, the
/// change of the effective N_i (N/m).
System glued(const System& system, bool forces = false);

/// The upper body may slip as a whole: all nodes have one slip s (m, landward), which is free, and no opening. s is the
/// last free unknown. Its residual is -F_T, the shear force on the lower body; there is no load of that name yet.
System with_rigid_slip(const System& system);

/// The upper body may slip and lift as a whole: the same with an interface of one node, which carries all forces.
System with_one_node(const System& system);

}  // namespace upbead
