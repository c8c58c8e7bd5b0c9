// The slip of the caisson in the reduced model of a case.
#pragma once

#include <functional>
#include <string>

#include "response/reduction.h"
#include "upbead/output/model_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// What `upbead reduce` has found of it.
struct ReducedSlip {
  std::optional<ModelSlip> model;  ///< none without [sliding]
  std::string why_not;             ///< with [sliding], where there is none
  double seconds = 0.;
};

/// Reduces the scene of a case with [sliding] once more, with a caisson that slips as a whole; `glued`: its model
/// without, whose response to the scene's loads trains it. `progress` is called with 0 to 1 after every solve.
ReducedSlip reduce_with_slip(const Simulation& simulation, const Reduction& glued,
                             const std::function<void(double)>& progress);

}  // namespace upbead
