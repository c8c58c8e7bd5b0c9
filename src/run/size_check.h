// Steps that are too many.
#pragma once

#include <optional>
#include <string>

#include "upbead/dynamics/time_grid.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Throws InputError where steps of that length (s) are too many; `because` says what set a length that the case does
/// not give.
void check_steps(const Scene& scene, double step, const std::optional<StepGrowth>& growth, const std::string& because);

}  // namespace upbead
