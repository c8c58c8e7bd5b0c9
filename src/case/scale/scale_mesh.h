// The mesh of a case at another size.
#pragma once

#include "factors.h"

namespace upbead {

/// Gives every parameter of the case's .geo that has a dimension its new value, also those that the case leaves at the
/// geometry's own. The unit of a parameter begins the comment behind it: "// m: height of the mound", or "// -: ..."
/// without one. Throws InputError where the mesh is finished (.msh), where no parameter is a length, and where a unit
/// or a value cannot be read.
void scale_mesh(const Case& problem, const ScaleOptions& options, Ratios& ratios, MeshChoice& mesh);

}  // namespace upbead
