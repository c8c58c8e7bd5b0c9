// How far apart the times of an answer may be, so that straight lines between them are the answer.
#pragma once

#include <vector>

#include "respond/wave_files.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// A model with one reading, and what of that reading a line may miss, over the largest answer of the first one.
struct ResolvedReading {
  const ModalModel* model;
  double tolerance;
};

/// How far one reading leaves the lines between its values at times h apart, whatever those times are. On lines of
/// load a mode z' = p z + b f has z'' = p z' + b f', which decays as exp(p t) and jumps by b times a change of slope
/// and by p b times a jump of f. So |z''| is known at every time, and a reading leaves its lines by no more than
/// |reading z''| min(h^2/8, 2/|p|^2) of each mode: the first bounds any function by its second derivative, the second
/// z'' = p^2 (z - line) itself.
class LineMisses {
 public:
  LineMisses(const ModalModel& model, const WaveFile& file, int wave);
  double at(double h) const;

 private:
  Eigen::ArrayXd bend_, fast_;  ///< of each mode, the largest |reading z''| and 2/|p|^2
  double of_integral_ = 0.;     ///< the same of an integral of the loads
};

/// The longest step (s) from `shortest` to `longest` by which no reading of any wave misses more than its tolerance of
/// the largest answer of the first one at the wave's own times. `shortest` where none will do.
double answer_step(const std::vector<ResolvedReading>& readings, const WaveFile& file, double shortest, double longest);

}  // namespace upbead
