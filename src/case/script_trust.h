// Whether to run a .geo of unknown origin where the system cannot confine gmsh.
#pragma once

#include "upbead/case/case.h"

namespace upbead {

/// A .geo is a program, which gmsh runs in a confined process (base/confined_work.h). Throws InputError where the
/// kernel has neither seccomp nor Landlock, the script is not one of the shipped geometries, and the user does not
/// vouch for it (--trust).
void require_trust(const Case& problem, bool trusted);

}  // namespace upbead
