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

/// How a scene is marched, and who looks.
struct Marching : MarchOptions {
  std::function<void(double)> beside{};  ///< progress of what is solved before or besides that march; may be null
  SoilFollower soil{};                   ///< see RunOptions::soil
  bool monitored = false;                ///< whether Monitors look, which the solution then has
};

/// One way to solve a scene in time.
struct Way {
  std::string name;      ///< name in messages and in the summary
  bool refined = false;  ///< a march whose solutions are refined, see SchemeOptions; only others keep checkpoints
  double part = 1.;      ///< length of the steps of a march, over the usual one
  bool reduced = false;  ///< by a reduced model
};

/// Marches of more and more work: as usual, with refined solutions, and, where the case leaves the scheme open, also in
/// shorter steps. Names are "SCHEME", "SCHEME, refined solutions, steps divided by 4".
std::vector<Way> ways_to_march(const Scene& given, const std::string& scheme);

/// The result of the first way by which solve() gives one that balances, with its ladder. Where none balances, the
/// result that comes closest, if it is bearable; it then needs a warning. Else throws NumericsError with all reasons.
Solution climb(const Simulation& simulation, const std::vector<Way>& ways, const Marching& marching,
               const std::function<Solution(const Way&, const Marching&)>& solve);

/// The balance that a result violates, see require_balance of response/shear_response.h. Throws NumericsError where
/// it stores more energy than the loads have supplied.
std::optional<Mismatch> imbalance(const Simulation& simulation, const Solution& solution);

/// Tolerable residual of the equation of motion of yielding soil, over the tolerance of the scene: the error of F_T
/// is then less than a thousandth of what the scene allows, see docs/yielding.md.
constexpr double yielding_tolerance = 2e-4;

/// Throws InputError where steps of that length (s) are too many; `because` says what set the length where the case
/// does not give it.
void check_steps(const Scene& scene, double step, const std::optional<StepGrowth>& growth, const std::string& because);

/// The summary of a reduction.
ReductionSummary summary_of(const Reduction& reduction);

/// Solves by the scheme that the case asks for or that is the least work; an interface must be bonded.
Solution run_bonded(const Simulation& simulation, const Marching& marching);

/// Text for a user whose scheme has been refused: whether "auto" would give a result, and how. Tries it.
std::string what_would_work(const Simulation& simulation, const std::function<void(double)>& progress);

/// Marches by that scheme, in `part` times the usual steps; `reason`: why the scheme was chosen. `in_place`: the
/// scheme's system where that is not the simulation's own but another one with the same loads, which sets no steps.
/// `known`: see choose_step.
Solution march_by(Scheme& scheme, const Simulation& simulation, const std::string& reason, const Marching& options,
                  double part = 1., const System* in_place = nullptr, KnownPeriods* known = nullptr);

}  // namespace upbead
