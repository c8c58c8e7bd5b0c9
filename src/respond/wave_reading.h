// One reading of a reduced model under waves, at the times of a grid.
#pragma once

#include <memory>
#include <string>

#include "dynamics/batch_response.h"
#include "respond/wave_grid.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// The model with only one of its readings; throws std::out_of_range where there is none of that name.
ModalModel one_reading(const ModalModel& model, const std::string& name);

/// Answers waves on one grid; safe to share between threads.
class WaveReading {
 public:
  /// `model`: has one reading.
  WaveReading(ModalModel model, const WaveGrid& grid);
  /// `ends_at_zero`: the waves' last sample is zero; a batch falls from the last sample to zero along a straight
  /// line.
  Eigen::RowVectorXd answer(const WaveSamples& loads, const WaveGrid& grid, bool ends_at_zero) const;

 private:
  ModalModel model_;
  std::unique_ptr<BatchResponse> batch_;
};

}  // namespace upbead
