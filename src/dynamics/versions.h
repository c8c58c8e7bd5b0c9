// What Fourier transforms are done with.
#pragma once

#include "base/version.h"

namespace upbead {

/// Of FFTW.
Versions dynamics_versions();

}  // namespace upbead
