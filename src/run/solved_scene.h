// A scene that has been solved, and what is said of it: a function of what was solved and of [sliding].
#pragma once

#include <functional>
#include <memory>

#include "run/monitors.h"
#include "run/sliding/slip_ahead.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Whether already the solution depends on [sliding], and not only what is said of it: friction node by node slips by
/// it, and a mesh for the tolerance is made for S, too.
bool needs_sliding(const Scene& scene);

/// What was solved of a scene. Its [sliding] is taken away before it is solved (but where needs_sliding()), so that
/// nothing of it can be left in what is said of the same scene with another [sliding].
class SolvedScene {
 public:
  SolvedScene(const Simulation& simulation, const RunOptions& options);

  /// The run of `given`, which is the scene that was solved, or, unless needs_sliding(), one that differs from it in
  /// [sliding] alone: sliding, errors, base, checks, warnings, what was skipped. Throws InputError at keys of the
  /// scene.
  Run run(const Scene& given, const std::function<void(double)>& progress) const& {
    return told(solved_, given, progress);
  }
  Run run(const Scene& given, const std::function<void(double)>& progress) && {
    return told(std::move(solved_), given, progress);
  }
  const Mesh& given_mesh() const { return *solved_.simulation->given_mesh; }

 private:
  Run told(Run run, const Scene& given, const std::function<void(double)>& progress) const;

  std::shared_ptr<const Simulation> simulation_;  ///< as it is solved
  mutable SlipAhead ahead_;  ///< gives away what it has begun, which is what is made anew without it
  Monitors monitors_;
  Run solved_;
};

}  // namespace upbead
