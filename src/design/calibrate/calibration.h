// The work of `upbead calibrate`.
#pragma once

#include "../design.h"
#include "design/calibrate.h"

namespace upbead {

/// A sound design.
Calibration calibrate(const Design& design);

}  // namespace upbead
