// Versions of the program and of its libraries.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace upbead {

/// "upbead 0.9.0".
const char* program_version();

/// Names and versions, such as {"PETSc", "3.18.5"}.
using Versions = std::vector<std::pair<std::string, std::string>>;

/// Versions of upbead and of the compiler that built it.
Versions base_versions();

}  // namespace upbead
