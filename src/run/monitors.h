// What a run tells besides its numbers: warnings, and what was skipped.
#pragma once

#include <optional>
#include <string>

#include "response/monitors.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Follows what could be wrong with a run while it is solved.
class Monitors {
 public:
  /// The scene as it will be solved, which must outlive it.
  explicit Monitors(const Simulation& simulation);

  /// Of a march, which they must outlive.
  std::vector<MarchObserver*> observers();

  /// Fills in title, loads, soil, strength, warnings and what was skipped.
  void report(Run& run);

 private:
  void report_pressure(const Simulation& simulation, Run& run);
  void report_strength(const Simulation& simulation, Run& run);

  std::optional<LeastPressure> pressure_;
  std::optional<Mobilisation> strength_;
  std::string why_no_pressure_, why_no_strength_;
};

}  // namespace upbead
