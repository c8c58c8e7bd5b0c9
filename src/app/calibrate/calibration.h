// The work of `upbead calibrate`.
#pragma once

#include "../design/design.h"
#include "upbead/app/calibrate.h"

namespace upbead {

/// A sound design.
Calibration calibrate(const Design& design);

}  // namespace upbead
