// A reduced model of soil that follows its strain is of the stiffness that one load has left.
#pragma once

#include <array>

#include "upbead/output/model_file.h"

namespace upbead {

/// Whether the soil of the model's case follows its strain.
bool follows_strain(const ReducedModelFile& model);

/// The largest P (N/m) of the loads by which it was made: that of the largest alone, and of all together at most.
std::array<double, 2> forces_of_case(const ReducedModelFile& model);

}  // namespace upbead
