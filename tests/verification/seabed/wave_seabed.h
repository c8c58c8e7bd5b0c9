// A poroelastic seabed under a standing wave of pressure p0 cos(k x) e^{i omega t} on its mudline. The domain is half a
// wave long and stands upright, because a load varies with the height only: the mudline is the vertical side x = 0,
// depth z runs along x and the wave along y. No gravity acts and the soil is isotropic, so that nothing else changes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frequency_response.h"
#include "reference.h"
#include "scenes.h"

namespace upbead::test {

/// What the tables call a seabed.
struct WaveSeabed {
  Region soil;
  Fluid fluid;
  bool inertia = true;
  double wavelength = 0., omega = 0.;  ///< m, rad/s
  double thickness = 0.;               ///< m, to a fixed and sealed bottom
  double water = 0.;                   ///< m, of modelled water on the mudline, whose level then has the pressure
  std::vector<double> depths;          ///< where it is read (m)
};

/// A table's case by one of its models: qs, upB or full. A half-space ends 2 wavelengths down, where e^{-kz} = 4e-6.
WaveSeabed wave_seabed(const Json& entry, const std::string& model);

/// Cells: `along` equal ones along half a wave; down from both the mudline and the bottom they start with the size
/// `first`, as both have a drained or sealed skin, and grow by `growth` up to `largest` (m).
struct SeabedMesh {
  int degree = 3;  ///< of u; of the pressure one less
  int along = 0;
  double first = 0., growth = 1., largest = 0.;
};

/// Complex amplitudes over the depths: of pressure, effective vertical stress and settlement under the crest, of shear
/// stress and horizontal displacement a quarter of a wave off. For p0 = 1 Pa.
struct SeabedResponse {
  std::vector<Complex> pressure, effective_stress, shear_stress, horizontal, vertical;
};

SeabedResponse respond(const WaveSeabed& seabed, const SeabedMesh& mesh);

}  // namespace upbead::test
