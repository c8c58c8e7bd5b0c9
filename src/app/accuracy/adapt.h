// The mesh that a tolerance asks for.
#pragma once

#include "upbead/app/pipeline.h"

namespace upbead {

/// Meshes coarsely, then splits the cells that make F_T wrong (mesh_error) until F_T moves little enough on cells half
/// as large (error_of_cells), and compiles the case on that; `accuracy` of what it returns is set. Throws InputError
/// where that cannot be measured or takes too many unknowns.
CompiledCase compile_adapted(const Case& input);

}  // namespace upbead
