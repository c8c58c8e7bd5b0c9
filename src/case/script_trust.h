// A .geo of somebody's where nothing can confine gmsh.
#pragma once

#include "upbead/case/case.h"

namespace upbead {

/// A .geo is a program, which gmsh runs in a confined process (base/confined_work.h). Throws InputError where the
/// kernel has neither seccomp nor Landlock, the script is not one of our own geometries, and no person vouches for it
/// (--trust).
void require_trust(const Case& problem, bool trusted);

}  // namespace upbead
