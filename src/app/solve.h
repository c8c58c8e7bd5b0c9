// Solving a compiled case in time: by marching, or by a reduced model.
#pragma once

#include <optional>

#include "upbead/app/pipeline.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/response/scheme_choice.h"

namespace upbead {

/// What people are told of a reduction.
ReductionSummary summary_of(const Reduction& reduction);

/// Marches; `choice` is a scheme that does, the observer sees every step.
Run run_march(const Case& input, const CompiledCase& scene, const SchemeChoice& choice, const MarchOptions& options);

/// Reduces the scene and answers its own loads. Where that fails and the case has left the scheme to us: none, and
/// `choice` becomes a march that says why. Throws NumericsError where the case has asked for it.
std::optional<Run> run_reduced(const Case& input, const CompiledCase& scene, SchemeChoice& choice,
                               const std::function<void(double)>& progress);

}  // namespace upbead
