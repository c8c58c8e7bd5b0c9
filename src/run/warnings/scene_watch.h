// What is looked at in all cells and nodes of a scene while it is solved.
#pragma once

#include <optional>
#include <string>

#include "response/least_pressure.h"
#include "response/mobilisation.h"
#include "upbead/run/simulation.h"

namespace upbead {

class SceneWatch {
 public:
  /// The scene as it will be solved, which must outlive it.
  explicit SceneWatch(const Simulation& simulation);

  /// Of a march, which the watch must outlive.
  std::vector<MarchObserver*> observers();

  /// Fills in the warnings of a run, its strength, and what of both is skipped.
  void tell(Run& run);

 private:
  void tell_pressure(const Simulation& simulation, Run& run);
  void tell_strength(Run& run) const;

  std::optional<LeastPressure> pressure_;
  std::optional<Mobilisation> strength_;
  std::string why_no_pressure_, why_no_strength_;
};

}  // namespace upbead
