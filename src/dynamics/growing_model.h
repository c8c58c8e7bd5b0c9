// A reduced model that grows look by look: for those who do not only wait until it agrees with the last smaller one.
#pragma once

#include <memory>

#include "upbead/dynamics/reduce.h"

namespace upbead {

/// What reduce() does, a look at a time. The System must outlive the object.
class GrowingModel {
 public:
  /// Throws as reduce() does, as grow() does.
  GrowingModel(const System& system, const ReduceOptions& options);
  ~GrowingModel();

  /// Enlarges the space up to the next look; false where it is exhausted or would take more than max_vectors.
  bool grow();
  /// The model of the last look, with its error against the look before; without what only finish() makes.
  const Reduction& reduction() const { return out_; }
  const ReducedSystem& system() const;
  /// What of the last two looks is told. To be called once.
  Reduction finish();

 private:
  struct Space;

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
