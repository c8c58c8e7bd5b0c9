// Peaks and their ratio, read off the histories of a wave.
#pragma once

#include <vector>

#include "output/wave_response.h"

namespace upbead {

/// Sets the peaks and the ratio from P and F_T at those times. `smooth`: F_T has no kinks, so that its peaks may be
/// looked for between the times.
void set_peaks(const std::vector<double>& time, const Eigen::RowVectorXd& P, const Eigen::RowVectorXd& F, bool smooth,
               WaveResponse& out);

}  // namespace upbead
