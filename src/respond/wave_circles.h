// Slip circles under the caisson in a wave, by the readings of a reduced model.
#pragma once

#include <optional>

#include "dynamics/readings_at.h"
#include "output/wave_response.h"
#include "respond/wave_grid.h"
#include "upbead/rupture/circle_family.h"
#include "upbead/sliding/base_pressure.h"

namespace upbead {

/// Answers waves on one grid; safe to share between threads.
class WaveCircles {
 public:
  WaveCircles(const CircleModel& model, const WaveGrid& grid);

  /// The least factor at rest and at the moments that may govern; none where no circle has a factor. `shear`: F_T;
  /// `batch`: the loads jump nowhere but at the beginning.
  std::optional<CircleInWave> answer(const WaveSamples& loads, const WaveGrid& grid, bool batch,
                                     const EffectiveBase& base, const Eigen::RowVectorXd& shear) const;

 private:
  const CircleModel& model_;
  std::optional<ReadingsAt> at_;  ///< where the times are equally spaced
};

/// Least friction over force while it pushes that way, mu N'/|F_T|; none where it never does.
std::optional<double> least_sliding_factor(double friction, const EffectiveBase& base, const Eigen::RowVectorXd& shear,
                                           double side);

}  // namespace upbead
