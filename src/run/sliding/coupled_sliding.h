// A caisson that slides as a rigid block on the moving ground.
#pragma once

#include <functional>
#include <string>

#include "run/sliding/slip_ahead.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/output/model_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Its slip, of a scene with [sliding], which is assembled with an interface and reduced: `ahead`, which may be null,
/// may have begun with that. `bonded`: the response without slip. Throws NumericsError where no distance can be found.
CoupledSummary slide_as_whole(const Simulation& simulation, SlipAhead* ahead, const Series& bonded,
                              const std::function<void(double)>& progress);

/// The slip model of `upbead reduce`, or why there is none.
struct ReducedSlip {
  std::optional<ModelSlip> model;  ///< none without [sliding]
  std::string why_not;             ///< reason, where there is [sliding] but no model
  double seconds = 0.;
};

/// Reduces the scene of a case with [sliding] again, now with a caisson that slips as a whole; `bonded`: its model
/// without slip, whose response to the scene's loads trains the new one. `progress` is called with 0 to 1 after every
/// solve.
ReducedSlip reduce_with_slip(const Simulation& simulation, const Reduction& bonded,
                             const std::function<void(double)>& progress);

}  // namespace upbead
