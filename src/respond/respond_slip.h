// S of many waves that slide a caisson which slips as a whole on the ground that it shakes.
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

/// U(t) >= 0 that follows P(t), given at ascending times (s), as the case has it; for shapes in_phase and held.
Eigen::RowVectorXd uplift_of_force(const ModelSliding& sliding, const std::vector<double>& time,
                                   const Eigen::RowVectorXd& P);

/// S (m) by eq. (4): F_T and U straight between the times; an empty U is none. mass: W/g (kg/m).
double sliding_distance(const ModelSliding& sliding, double mass, const std::vector<double>& time,
                        const Eigen::RowVectorXd& F_T, const Eigen::RowVectorXd& U);

/// A load that prescribes a pore pressure is two loads of the system, with one history: makes them one again.
void join_pore_pressures(ModalModel& model);

/// Slides waves of one step.
struct WaveSlip {
  CoupledSlip slip;
  std::optional<CoupledSlip> more_damped;  ///< where the model has damping for the numerics: twice as much
};

/// One law of friction on a reduced model; waves with the same steps share what is dear to make.
class WaveSlips {
 public:
  /// Throws InputError where the part of the model that slips does not have its loads, NumericsError as slip_model().
  WaveSlips(const ReducedModelFile& model, const ModelSliding& sliding);

  /// `step`: of the samples, or about so (s).
  std::shared_ptr<const WaveSlip> of_step(double step);

 private:
  SlipModel model_;
  std::optional<SlipModel> more_damped_;
  std::map<double, std::shared_ptr<const WaveSlip>> made_;
};

/// S of a wave, or why it cannot be told.
struct SlipOfWave {
  std::optional<CoupledWave> coupled;
  std::string why_not;
};

/// Loads on the grid, and N_0 = W' less the part of the uplift that the model does not tell, `prescribed` (N/m; empty:
/// none), straight between the times. After the grid no load acts and N_0 = W': the slip is followed to its stop.
/// - batch: the grid has equal steps and no jump but at its beginning; the loads then fall to zero within one step.
SlipOfWave slip_of_wave(const WaveSlip& slip, const WaveSamples& loads, const WaveGrid& grid, bool batch,
                        double submerged_weight, const Eigen::RowVectorXd& prescribed);

}  // namespace upbead
