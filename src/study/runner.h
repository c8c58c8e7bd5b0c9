// Runs of a study, one after the other in one process.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "study/results.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Keeps the mesh while runs ask for the same one, and what was solved while runs differ only in [sliding]. Both equal
/// what the run would have made for itself, so every number is the same to the last bit, whatever ran before.
class Runner {
 public:
  /// `trusts_scripts`: see require_trust().
  Runner(const Study& study, bool sharing, bool trusts_scripts)
      : study_(study), sharing_(sharing), trusts_scripts_(trusts_scripts) {}
  /// A run that fails says so in its result. `meanwhile` is called during the run. Throws Interrupted.
  RunResult run(const StudyRun& run, const std::function<void()>& meanwhile);

 private:
  Summary solve(const Case& problem, const std::function<void()>& meanwhile, Shared& shared);
  std::shared_ptr<const Mesh> mesh_for(const Case& problem, Shared& shared);

  const Study& study_;
  bool sharing_;
  bool trusts_scripts_;
  std::string mesh_key_, solution_key_;
  std::shared_ptr<const Mesh> mesh_;
  std::optional<Solution> solved_;
};

}  // namespace upbead
