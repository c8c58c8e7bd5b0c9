// Output of a run besides its numbers: warnings, and what was skipped.
#pragma once

#include <optional>
#include <string>

#include "response/monitors.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Watches a run while it is solved, for all that could be wrong.
class Monitors {
 public:
  /// For the simulation that will be solved; it must outlive this object.
  explicit Monitors(const Simulation& simulation);

  /// The observers of a march; this object must outlive the march.
  std::vector<MarchObserver*> observers();

  /// Looks at what a reduced model answers, where the run was not marched; once, before report().
  void look(const Run& run);
  /// Fills in title, loads, soil, strength, warnings and what was skipped.
  void report(Run& run) const;

 private:
  void report_pressure(const Simulation& simulation, Run& run) const;
  void report_strength(Run& run) const;

  std::optional<LeastPressure> pressure_;
  std::optional<Mobilisation> strength_;
  std::string why_no_pressure_, why_no_strength_;
};

}  // namespace upbead
