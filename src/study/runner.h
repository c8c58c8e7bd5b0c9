// Runs of a study, one after the other in one process.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "study/results.h"
#include "study/soil_runs.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Keeps the stages of the run before: its mesh, its System, the basis of its reduced model, its Solution. A run enters
/// at the last stage whose own inputs are the same, and makes the later ones. What is kept equals what the run would
/// have made for itself, so every number is the same to the last bit, whatever ran before. What a stage depends on:
/// mesh and Solution in runner.cc, System in fem/system_scene.h, basis in dynamics/basis.h. Many soils have one model,
/// whose answers differ from a run's own by what they tell, `reduction.error_of_soils`.
class Runner {
 public:
  /// `folder`: of the results, with the families of soils that make_soil_families() has written; `trusts_scripts`: see
  /// require_trust().
  Runner(const Study& study, const std::string& folder, bool sharing, bool trusts_scripts)
      : study_(study),
        sharing_(sharing && study.share != StudyShare::none),
        trusts_scripts_(trusts_scripts),
        soils_(study, folder) {}
  /// A run that fails says so in its result. `meanwhile` is called during the run. Throws Interrupted.
  RunResult run(int number, const std::function<void()>& meanwhile);

 private:
  RunResult answer_of(int run, const Case& problem, const std::function<void()>& meanwhile);
  Summary solve(int run, const Case& problem, bool as_member, const std::function<void()>& meanwhile, Shared& shared);
  std::shared_ptr<const Mesh> mesh_for(const Case& problem, Shared& shared);
  Simulation own_simulation(const Case& problem, Shared& shared);
  Simulation simulation_for(int run, const Case& problem, bool as_member, Shared& shared);

  const Study& study_;
  bool sharing_;
  bool trusts_scripts_;
  SoilRuns soils_;
  std::string mesh_key_, solution_key_;
  std::shared_ptr<const Mesh> mesh_;
  std::optional<Simulation> before_;  ///< as the run before made it, with its System and the room for its basis
  std::optional<Solution> solved_;
};

}  // namespace upbead
