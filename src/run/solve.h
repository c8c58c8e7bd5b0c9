// Solving a compiled case in time: by marching, or by a reduced model.
#pragma once

#include "response/scheme_choice.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// What people are told of a reduction.
ReductionSummary summary_of(const Reduction& reduction);

/// Solves by the way that the case asks for or that is least work, and reads F_T and the sliding; an interface must be
/// glued.
Run run_glued(const Simulation& simulation, const MarchOptions& marching, const std::function<void(double)>& reducing);

/// How a march is done with more care than usual.
struct Care {
  bool refined = false;  ///< see SchemeOptions
  double part = 1.;      ///< of the usual steps
};

/// Marches by that scheme, chosen for that reason, in `part` times the usual steps.
Run march_by(Scheme& scheme, const Simulation& simulation, const std::string& reason, const MarchOptions& options,
             double part = 1.);

/// Marches; `choice` is a scheme that does, the observer sees every step.
Run run_march(const Simulation& simulation, const SchemeChoice& choice, const MarchOptions& options,
              const Care& care = {});

/// Reduces the scene and answers its own loads. A case that asks for a reduced model gets one whose F_T meets the
/// tolerance; readings that do not are listed in its summary. Throws NumericsError where it does not converge.
Run run_reduced(const Simulation& simulation, const SchemeChoice& choice, const std::function<void(double)>& progress);

}  // namespace upbead
