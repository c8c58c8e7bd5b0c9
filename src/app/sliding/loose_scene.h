// The scene of a case with a caisson that slips on its ground as a whole.
#pragma once

#include <string>

#include "upbead/app/pipeline.h"

namespace upbead {

/// Why such a slip cannot be told of a scene with a caisson; "" where it can.
std::string why_no_slip(const CompiledCase& scene);

/// The scene with an interface, on one process; what its unknowns mean is not asked for any more.
CompiledScene compile_loose(const CompiledCase& scene);

}  // namespace upbead
