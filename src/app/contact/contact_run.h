// Solving a case whose caisson may slip and lift, node by node.
#pragma once

#include "upbead/app/pipeline.h"

namespace upbead {

/// Solves the scene glued first, which tells S by other measures, too. Where no node reaches its friction or pulls,
/// that is the answer; else it is marched with the law of contact. The compiled system must have an interface; it is
/// the one that the answer belongs to in the end. `marching` as in run_case. Throws NumericsError.
Run run_contact(const Case& input, CompiledCase& scene, const MarchOptions& marching,
                const std::function<void(double)>& progress);

}  // namespace upbead
