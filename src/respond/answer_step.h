// The largest step between times of a response such that straight lines between them reproduce the response.
#pragma once

#include <vector>

#include "respond/wave_files.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// A model with one reading, and the tolerable error of straight lines, over the largest value of the first such
/// reading.
struct ResolvedReading {
  const ModalModel* model;
  double tolerance;
};

/// How far one reading may be from straight lines between its values at times h apart, wherever these times are.
/// Under straight loads a mode z' = p z + b f has z'' = p z' + b f', which decays as exp(p t) and jumps by b times a
/// change of slope and by p b times a jump of f. So |z''| is bounded at every time, and the reading is within
/// |reading z''| min(h^2/8, 2/|p|^2) of its lines, summed over the modes: the first bounds any function by its second
/// derivative, the second follows from z'' = p^2 (z - line) itself.
class LineMisses {
 public:
  LineMisses(const ModalModel& model, const WaveFile& file, int wave);
  double at(double h) const;

 private:
  Eigen::ArrayXd bend_, fast_;  ///< for each mode, the largest |reading z''| and 2/|p|^2
  double of_integral_ = 0.;     ///< the same for an integral of the loads
};

/// The longest step (s) from `shortest` to `longest` with which the lines of every reading stay within its tolerance
/// for all waves; tolerances are over the largest value of the first reading at the wave's own times. `shortest`
/// where no step does.
double answer_step(const std::vector<ResolvedReading>& readings, const WaveFile& file, double shortest, double longest);

}  // namespace upbead
