// The fits of k over the waves of a model.
#pragma once

#include "design/calibrate.h"

namespace upbead {

/// By every measure: for each r, and for all r together; tau_0 by impulse is the same at every r and fitted once.
std::vector<CalibrationFit> fits(const CalibratedModel& model, const std::vector<double>& ratios,
                                 const DurationFactor& given);

}  // namespace upbead
