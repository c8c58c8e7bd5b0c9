// --trust: a .geo of somebody's where nothing can confine gmsh.
#pragma once

#include <CLI/CLI.hpp>

#include "upbead/case/case.h"

namespace upbead {

/// Adds --trust to a command that meshes.
void add_trust_option(CLI::App& command, bool& trusted);

/// A .geo is a program, which gmsh runs in a confined process (base/confined_work.h). Throws InputError where the
/// kernel has neither seccomp nor Landlock, the script is not one of our own geometries, and no person vouches for it.
void require_trust(const Case& problem, bool trusted);

}  // namespace upbead
