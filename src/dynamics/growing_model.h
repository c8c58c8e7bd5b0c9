// A reduced model that grows from look to look, for callers with work to do in between. At a look the model is
// compared with the one of the look before.
#pragma once

#include <functional>
#include <memory>

#include "upbead/dynamics/reduce.h"

namespace upbead {

class GrowingBasis;
class Looks;
struct Look;

/// The work of reduce(), one look at a time. The System is read by the constructor alone.
class GrowingModel {
 public:
  /// Throws as reduce() does; so does grow().
  GrowingModel(const System& system, const ReduceOptions& options, BasisRoom* room = nullptr);
  /// By looks whose models options.model makes. Of the options only those count that a basis serves alike.
  GrowingModel(std::shared_ptr<Looks> looks, const ReduceOptions& options);
  ~GrowingModel();

  /// Makes the vectors of the first look, which need no training: most of the work where these are enough.
  void prepare();
  /// To be called before the first look: training histories in place of those of the options, and a function that is
  /// called after every solve from now on.
  void train(const SampledLoads& training, const std::function<void(double)>& progress);
  /// Enlarges the space up to the next look; false where it is exhausted or would take more than max_vectors.
  bool grow();
  /// The model of the last look, with its error against the look before; without the parts that only finish() makes.
  const Reduction& reduction() const { return out_; }
  /// Of the last look.
  const ReducedSystem& system() const;
  /// Completes the result from the last two looks. To be called once.
  Reduction finish();

 private:
  const Look& look_at(std::size_t number);
  void compare_looks(const ModalModel& model, const ModalModel& kept, const std::vector<Eigen::MatrixXd>& now);

  ReduceOptions options_;
  std::shared_ptr<Looks> looks_;
  std::shared_ptr<GrowingBasis> basis_;  ///< the same, where the models are its modes
  Reduction out_;
  std::vector<SampledLoads> loads_;
  std::vector<Eigen::MatrixXd> before_;  ///< responses at the last look
  ModalModel coarse_;                    ///< of the look before the last
  ModalModel kept_;                      ///< of the coordinates that are kept, at the last look
  const Look* look_ = nullptr;           ///< the last one
  std::size_t n_looks_ = 0;
};

}  // namespace upbead
