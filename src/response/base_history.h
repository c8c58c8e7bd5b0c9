// The forces at the caisson's bottom over time, for what slides on them.
#pragma once

#include <vector>

#include "fem/compile.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// All are straight between their times. Changes against still water; SI, per metre.
struct BaseHistory {
  std::vector<double> time;          ///< also inside steps; two equal ones where a force jumps (s)
  std::vector<double> shear_force;   ///< F_T, landward
  std::vector<double> force;         ///< P, landward
  std::vector<double> step_time;     ///< ends of the steps (s)
  std::vector<double> normal_force;  ///< change of the total normal force, compression positive
  std::vector<double> uplift;        ///< integral of the excess pore pressure over the bottom
};

/// Needs a scene with a caisson. F_T inside the steps as in read_shear_response; without inertia its values at their
/// ends.
BaseHistory read_base_history(const CompiledScene& compiled, const Response& response, bool inertia);

}  // namespace upbead
