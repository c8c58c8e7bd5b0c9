// What is looked at in all cells and nodes of a scene while it is solved.
#pragma once

#include <optional>
#include <string>

#include "upbead/app/pipeline.h"
#include "upbead/response/least_pressure.h"
#include "upbead/response/mobilisation.h"

namespace upbead {

class SceneWatch {
 public:
  /// The scene as it will be solved, which must outlive it.
  explicit SceneWatch(const CompiledCase& scene);

  /// Options with an observer that looks before the one given, and remembers in checkpoints. The watch must outlive
  /// the march.
  MarchOptions watching(const MarchOptions& marching);

  /// Fills in the warnings of a run, its strength, and what of both is skipped.
  void tell(const Case& input, const CompiledCase& scene, Run& run);

 private:
  std::vector<double> memory() const;
  void recall(const std::vector<double>& memory);
  void tell_pressure(const CompiledCase& scene, Run& run);
  void tell_strength(Run& run) const;

  std::optional<LeastPressure> pressure_;
  std::optional<Mobilisation> strength_;
  std::string why_no_pressure_, why_no_strength_;
  std::vector<double> unseen_;  ///< memory before the first march
  bool saw_a_march_ = false;
};

}  // namespace upbead
