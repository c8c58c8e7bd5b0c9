// How finely the ground near the caisson is meshed for the waves that it sends out.
#pragma once

#include <string>
#include <vector>

#include "fem/compile.h"

namespace upbead {

/// One region within a wavelength of the caisson's bottom.
struct WaveResolution {
  std::string region;
  double speed = 0.;       ///< V_s, mean over its area (m/s)
  double wavelength = 0.;  ///< V_s D + B (m)
  double cell = 0.;        ///< root of the area of the largest cell there (m)
  double cells_per_wave() const { return wavelength / cell; }
};

/// Of every region that deforms. D is the shortest duration of the loads (s), B the width of the caisson's bottom: a
/// body as wide as that sends out no shorter waves, however short the load is. So measured on the shipped section, D
/// from 0.02 to 0.4 s: docs/warnings.md. Needs a caisson.
std::vector<WaveResolution> wave_resolution(const Space& space, const Caisson& caisson, double duration);

/// V_s of a cell that deforms (m/s), 0 of any other.
double shear_speed(const Space& space, const Space::MeshCell& cell);

}  // namespace upbead
