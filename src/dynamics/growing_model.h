// A reduced model that grows look by look: for those who do not only wait until it agrees with the last smaller one.
#pragma once

#include <functional>
#include <memory>

#include "upbead/dynamics/reduce.h"

namespace upbead {

/// What reduce() does, a look at a time. The System must outlive the object.
class GrowingModel {
 public:
  /// Throws as reduce() does, as grow() does.
  GrowingModel(const System& system, const ReduceOptions& options);
  ~GrowingModel();

  /// Makes the vectors of the first look, which need no training: most of the work of a model that few are enough for.
  void prepare();
  /// Histories instead of those of the options, before the first look, and what is called after every solve from now
  /// on.
  void train(const SampledLoads& training, const std::function<void(double)>& progress);
  /// Enlarges the space up to the next look; false where it is exhausted or would take more than max_vectors.
  bool grow();
  /// The model of the last look, with its error against the look before; without what only finish() makes.
  const Reduction& reduction() const { return out_; }
  const ReducedSystem& system() const;
  /// What of the last two looks is told. To be called once.
  Reduction finish();

 private:
  struct Space;

  void reach_target();
  void compare_looks(const ModalModel& model, const ModalModel& kept, const std::vector<Eigen::MatrixXd>& now);

  ReduceOptions options_;
  std::unique_ptr<Space> space_;
  Reduction out_;
  std::vector<SampledLoads> loads_;
  std::vector<Eigen::MatrixXd> before_;  ///< what the last look answered
  ModalModel coarse_;                    ///< of the look before it
  ModalModel kept_;                      ///< of the coordinates that are kept, at the last look
  int target_ = 0, most_ = 0;            ///< vectors at the next look, and at any
  bool exhausted_ = false;
};

}  // namespace upbead
