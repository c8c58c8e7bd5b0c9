// How finely the ground near the caisson is meshed for the waves that it sends out.
#pragma once

#include <string>
#include <vector>

#include "fem/compile.h"
#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"

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
/// from 0.02 to 0.4 s: docs/warnings.md. Needs a caisson; `scene` as solved.
std::vector<WaveResolution> wave_resolution(const Scene& scene, const Mesh& mesh, const Caisson& caisson,
                                            double duration, const SoilState& soil = {});

/// V_s of a cell that deforms (m/s), 0 of any other; `soil`: what differs from cell to cell.
double shear_speed(const Scene& scene, const Mesh& mesh, const dealii::Triangulation<dim>::active_cell_iterator& cell,
                   const SoilState& soil);

}  // namespace upbead
