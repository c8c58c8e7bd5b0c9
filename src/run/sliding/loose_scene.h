// The scene of a case with a caisson that slips on its ground as a whole.
#pragma once

#include <string>

#include "fem/compile.h"
#include "response/slip_reduction.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Why such a slip cannot be told of a scene with a caisson; "" where it can.
std::string why_no_slip(const Simulation& simulation);

/// The scene with an interface, on one process; what its unknowns mean is not asked for any more.
CompiledScene compile_loose(const Simulation& simulation);

/// What N' is without, by [sliding].
SlipUplift slip_uplift(const SlidingChoice& choice);

/// reduce_slip() for the uplift of the scene's [sliding]. Throws NumericsError where that does not come to the
/// tolerance besides.
SlipReduction reduce_loose(const Scene& scene, const CompiledScene& loose, const Series& glued,
                           const std::function<void(double)>& progress);

}  // namespace upbead
