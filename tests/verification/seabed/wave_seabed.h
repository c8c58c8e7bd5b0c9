// A poroelastic seabed under a standing wave of pressure p0 cos(k x) e^{i omega t} on its mudline. The domain is half
// a wavelength long and is turned by 90 degrees, because a load can vary only with the height: the mudline is the
// vertical side x = 0, depth z runs along x and the wave along y. No gravity acts and the soil is isotropic, so that
// nothing else changes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frequency_response.h"
#include "reference.h"
#include "scenes.h"

namespace upbead::test {

/// The seabed of an entry of the tables.
struct WaveSeabed {
  Region soil;
  Fluid fluid;
  bool inertia = true;
  double wavelength = 0., omega = 0.;  ///< m, rad/s
  double thickness = 0.;               ///< m, to a fixed and sealed bottom
  /// m, thickness of modelled water on the mudline; the pressure then acts on its level
  double water = 0.;
  std::vector<double> depths;  ///< of the readings (m)
};

/// A table's case by one of its models: qs, upB or full. A half-space ends 2 wavelengths down, where e^{-kz} = 4e-6.
WaveSeabed wave_seabed(const Json& entry, const std::string& model);

/// Cells: `along` equal cells along half a wavelength; in depth, cells start at both the mudline and the base with
/// the size `first`, as both have a thin boundary layer, and grow by `growth` up to `largest` (m).
struct SeabedMesh {
  int degree = 3;  ///< of u; of the pressure one less
  int along = 0;
  double first = 0., growth = 1., largest = 0.;
};

/// Complex amplitudes over the depths: of pressure, effective vertical stress and settlement under the crest, of
/// shear stress and horizontal displacement a quarter of a wavelength from it. For p0 = 1 Pa.
struct SeabedResponse {
  std::vector<Complex> pressure, effective_stress, shear_stress, horizontal, vertical;
};

SeabedResponse respond(const WaveSeabed& seabed, const SeabedMesh& mesh);

}  // namespace upbead::test
