// Solving a compiled case in time: by marching, or by a reduced model.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "response/shear_response.h"
#include "response/time_choice.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/dynamics/time_grid.h"
#include "upbead/model/scene.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// How a march is done with more care than usual.
struct Care {
  bool refined = false;  ///< see SchemeOptions
  double part = 1.;      ///< of the usual steps
};

/// One way to solve a scene in time.
struct Way {
  std::string name;  ///< as people are told it, in the summary too
  std::function<Run(const MarchOptions&)> solve;
  bool keeps_checkpoints = false;  ///< of all ways one may
};

/// A march with more and more care: as usual, with refined solutions, and, where the case leaves the scheme to us, in
/// shorter steps too. Names are "SCHEME", "SCHEME, refined solutions, steps divided by 4".
std::vector<Way> ways_with_care(const Scene& given, const std::string& scheme,
                                const std::function<Run(const MarchOptions&, const Care&)>& solve);

/// The answer of the first way that gives one and balances, with the ladder so far in its summary. Where none balances,
/// that which comes closest, as long as it is bearable: it is to be warned of. Else throws NumericsError with all
/// reasons.
Run climb(const Simulation& simulation, const std::vector<Way>& ways, const MarchOptions& marching);

/// What does not balance in an answer, see require_balance of response/shear_response.h. Throws NumericsError where it
/// stores more energy than the loads have brought.
std::optional<Mismatch> imbalance(const Simulation& simulation, const Run& run);

/// Residual of the equation of motion of soil that yields, over the tolerance of the scene: F_T is then wrong by less
/// than a thousandth of what the scene allows, see docs/yielding.md.
constexpr double yielding_tolerance = 2e-4;

/// Throws InputError where steps of that length (s) are too many; `because` says what set a length that the case does
/// not give.
void check_steps(const Scene& scene, double step, const std::optional<StepGrowth>& growth, const std::string& because);

/// What people are told of a reduction.
ReductionSummary summary_of(const Reduction& reduction);

/// Solves by the way that the case asks for or that is least work, and reads F_T and the sliding; an interface must be
/// bonded.
Run run_bonded(const Simulation& simulation, const MarchOptions& marching, const std::function<void(double)>& reducing);

/// The same of a caisson that may not slip: a scene that names a scheme is told, where that is refused, whether another
/// one answers. Contact has but one.
Run run_tied(const Simulation& simulation, const MarchOptions& marching, const std::function<void(double)>& reducing);

/// Marches by that scheme, chosen for that reason, in `part` times the usual steps.
Run march_by(Scheme& scheme, const Simulation& simulation, const std::string& reason, const MarchOptions& options,
             double part = 1.);

/// Marches; `choice` is a scheme that does, the observer sees every step.
Run run_march(const Simulation& simulation, const SchemeChoice& choice, const MarchOptions& options,
              const Care& care = {});

}  // namespace upbead
