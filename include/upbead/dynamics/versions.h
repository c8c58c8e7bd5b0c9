// What Fourier transforms are done with.
#pragma once

#include "upbead/base/version.h"

namespace upbead {

/// Of FFTW.
Versions dynamics_versions();

}  // namespace upbead
