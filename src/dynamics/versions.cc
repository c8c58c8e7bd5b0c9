#include "dynamics/versions.h"

#include <fftw3.h>

namespace upbead {

Versions dynamics_versions() {
  return {{"FFTW", fftw_version + sizeof "fftw"}};  // of "fftw-3.3.10-sse2-avx"
}

}  // namespace upbead
