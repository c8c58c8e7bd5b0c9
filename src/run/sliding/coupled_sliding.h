// S by every measure: by formulas on the history of F_T, and of a caisson that slips as a whole on its ground.
#pragma once

#include <functional>
#include <string>

#include "run/sliding/slip_ahead.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/output/model_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Computes the sliding of a bonded run with [sliding]; without it nothing. Where the caisson never reaches its
/// friction, the coupled S is zero and needs no work; else the scene is compiled with an interface and reduced, which
/// also gives a history. `ahead` may have begun with that.
void read_sliding(const Simulation& simulation, SlipAhead& ahead, Run& run,
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
