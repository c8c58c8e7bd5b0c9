// Solving a compiled case in time: by marching, or by a reduced model.
#pragma once

#include <optional>

#include "upbead/app/pipeline.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/response/scheme_choice.h"

namespace upbead {

/// What people are told of a reduction.
ReductionSummary summary_of(const Reduction& reduction);

/// Solves by the way that the case asks for or that is least work, and reads F_T and the sliding; an interface must be
/// glued.
Run run_glued(const Case& input, const CompiledCase& scene, const MarchOptions& marching,
              const std::function<void(double)>& reducing);

/// Marches by that scheme, chosen for that reason.
Run march_by(Scheme& scheme, const Case& input, const CompiledCase& scene, const std::string& reason,
             const MarchOptions& options);

/// Marches; `choice` is a scheme that does, the observer sees every step.
Run run_march(const Case& input, const CompiledCase& scene, const SchemeChoice& choice, const MarchOptions& options);

/// Reduces the scene and answers its own loads. Where that fails and the case has left the scheme to us: none, and
/// `choice` becomes a march that says why. Throws NumericsError where the case has asked for it.
std::optional<Run> run_reduced(const Case& input, const CompiledCase& scene, SchemeChoice& choice,
                               const std::function<void(double)>& progress);

}  // namespace upbead
