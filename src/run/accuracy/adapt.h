// The mesh that a tolerance asks for.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Splits the cells of a coarse mesh that make F_T wrong (mesh_error) until F_T moves little enough on cells half
/// as large (error_of_cells), and assembles the scene on that; `accuracy` of what it returns is set. Throws InputError
/// where that cannot be measured or takes too many unknowns.
Simulation adapted(const Scene& given, std::shared_ptr<const Mesh> coarse);

}  // namespace upbead
