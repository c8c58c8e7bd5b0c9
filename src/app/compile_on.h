// Compiling a case on a mesh that is at hand.
#pragma once

#include "upbead/app/pipeline.h"

namespace upbead {

/// Checks the scene on the mesh and compiles it, for `processes` undivided: see compile(). Throws InputError with all
/// objections at their places in the case.
CompiledCase compile_on(const Case& input, std::shared_ptr<const Mesh> mesh,
                        std::shared_ptr<const Processes> processes = nullptr);

}  // namespace upbead
