#include "respond/wave_reading.h"

#include "upbead/dynamics/modal_response.h"

namespace upbead {

ModalModel one_reading(const ModalModel& model, const std::string& name) {
  return model.with_reading(model.index(name));
}

WaveReading::WaveReading(ModalModel model, const WaveGrid& grid) : model_(std::move(model)) {
  if (grid.equal) batch_ = std::make_unique<BatchResponse>(model_, 0, *grid.equal);
}

Eigen::RowVectorXd WaveReading::answer(const WaveSamples& loads, const WaveGrid& grid, bool ends_at_zero) const {
  Eigen::RowVectorXd y(loads.cols());
  if (batch_ && ends_at_zero)
    batch_->respond(loads, y);
  else
    y = respond(model_, with_jumps(loads, grid)).reading.row(0);
  return y;
}

}  // namespace upbead
