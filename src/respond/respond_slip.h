// S of many waves, for a caisson that slides as a rigid block on the moving ground.
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/wave_response.h"
#include "respond/wave_grid.h"
#include "sliding/coupled_slip.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/output/model_file.h"

namespace upbead {

/// Whether waves press on the landward wall alone: then all is as in a mirror.
bool pushes_seaward_alone(const Eigen::RowVectorXd& P);

/// U(t) >= 0 that follows P(t), given at ascending times (s), as in the case; for the shapes in_phase and held. It
/// follows a landward P, or one that is never landward.
Eigen::RowVectorXd uplift_of_force(const ModelSliding& sliding, const std::vector<double>& time,
                                   const Eigen::RowVectorXd& P);

/// S (m) by eq. (4): F_T, to which still water's push is added, and U are straight between the times; an empty U stands
/// for no uplift. mass: W/g (kg/m).
double sliding_distance(const ModelSliding& sliding, double mass, const std::vector<double>& time,
                        const Eigen::RowVectorXd& shear, const Eigen::RowVectorXd& U);

/// Computes the slip of waves with one step.
struct WaveSlip {
  CoupledSlip slip;
  std::optional<CoupledSlip> more_damped;  ///< with twice the damping, where the model has damping for the numerics
};

/// One law of friction on a reduced model; waves with the same step share what is expensive to make.
class WaveSlips {
 public:
  /// Throws InputError where the slip part of the model has other loads than the model, NumericsError as
  /// slip_model().
  WaveSlips(const ReducedModelFile& model, const ModelSliding& sliding);

  /// `step`: of the samples, at least approximately (s).
  std::shared_ptr<const WaveSlip> of_step(double step);

 private:
  SlipModel model_;
  std::optional<SlipModel> more_damped_;
  std::map<double, std::shared_ptr<const WaveSlip>> made_;
};

/// S of a wave, or why it could not be computed.
struct SlipOfWave {
  std::optional<CoupledWave> coupled;
  std::string why_not;
};

/// Loads on the grid, and N_0 = W' minus the part of the uplift that the model does not compute, `prescribed` (N/m;
/// empty: none), straight between the times. After the grid no load acts and N_0 is W', less an uplift that is held;
/// the slip is followed until it stops.
/// - batch: the grid has equal steps and a jump only at its beginning; the loads then fall to zero within one step.
SlipOfWave slip_of_wave(const WaveSlip& slip, const WaveSamples& loads, const WaveGrid& grid, bool batch,
                        const ModelSliding& sliding, const Eigen::RowVectorXd& prescribed);

}  // namespace upbead
