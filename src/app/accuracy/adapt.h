// The mesh that a tolerance asks for.
#pragma once

#include "upbead/app/pipeline.h"

namespace upbead {

/// Meshes coarsely, then splits the cells that make F_T wrong (mesh_error) until their errors add up to no more than
/// most of the case's tolerance, and compiles the case on that. Throws InputError where that cannot be measured or
/// takes too many unknowns.
CompiledCase compile_adapted(const Case& input);

}  // namespace upbead
