// True and estimated errors of reduced models of different scenes under random records.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "discrete_kernel.h"
#include "random_records.h"
#include "scenes.h"
#include "upbead/dynamics/nested_models.h"
#include "upbead/dynamics/reduce.h"

namespace upbead::test {

/// A breakwater on its mesh; the load is a triangle of `duration`, the scene ends at `end` (s).
struct ErrorScene {
  std::string name;
  Scene scene;
  std::unique_ptr<Mesh> mesh;
  double duration, end;
};

/// Names of all scenes; the first `n_calibrating` were used to calibrate the safety factor of the bound.
const std::vector<std::string>& error_scene_names();
constexpr int n_calibrating = 3;
/// `cells`: as of breakwater_mesh().
ErrorScene error_scene(const std::string& name, double cells);

/// One record: errors against the truth (SDIRK on a fine grid) and their estimate; all over the largest |F_T|.
struct WaveError {
  std::string kind;
  double length, duration;     ///< over those of the scene
  double truth_error;          ///< of the truth itself, from twice its step
  double error, peak_error;    ///< of the history, of the largest |F_T|
  double of_model, of_middle;  ///< differences of nested models
  double estimate;             ///< of ResponseDifference::bound()
};

/// The reduced model of a scene, and the truth (by half the steps) on a grid of `steps` steps per duration, up to
/// `length` times the scene's end.
class WaveErrors {
 public:
  WaveErrors(const ErrorScene& scene, double steps, double length, unsigned seed);
  /// The errors for the next random record; its duration is 0.1 (at least 8 steps) to 100 times the scene's, its
  /// length 0.1 to `length` times the scene's end; the response lasts until the end of the record or of the scene.
  WaveError next();
  const Reduction& reduction() const { return reduction_; }
  const NestedModels& nested() const { return nested_; }
  int unknowns() const { return compiled_.system.n_free(); }
  double reduce_seconds = 0., nested_seconds = 0.;

 private:
  Compiled compiled_;
  double end_, duration_, step_;
  int n_, shear_;
  Reduction reduction_;
  NestedModels nested_;
  Kernel kernel_, coarse_kernel_;  ///< with steps of step_ / 2 and step_
  RandomRecords records_;
};

}  // namespace upbead::test
