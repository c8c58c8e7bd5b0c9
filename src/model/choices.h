// What a case leaves to be chosen in a region, chosen from numbers. A stated choice is always kept. Limits are
// measured: docs/skipping.md.
#pragma once

#include <string>
#include <vector>

#include "upbead/model/scene.h"

namespace upbead {

/// What a choice needs to know of a region's place in the mesh.
struct Surroundings {
  double height = 0.;                ///< of the region (m)
  double width = 0.;                 ///< of the region (m)
  bool has_open_side = false;        ///< of an outer side with pressure open or surface_waves
  bool is_held = false;              ///< at an outer side, fixed, on rollers or absorbing
  bool has_load = false;             ///< a pressure on one of its outer sides, or one on its pore water
  bool has_probe = false;            ///< or fields are asked for
  bool touches_water = false;        ///< free water
  std::vector<std::string> touches;  ///< other regions
};

/// Why a region's pore water is treated as it is.
struct FlowChoice {
  Flow flow = Flow::darcy;
  double X = 0.;       ///< k omega / (g n), ratio of fluid inertia to drag; 0 without a load
  std::string reason;  ///< for people, with the number
};

/// Darcy where X [Zienkiewicz, Chang and Bettess 1980] is small up to the end of the loads' spectrum, omega =
/// bandwidth(scene), inertial above. Drained where the pressure leaves within 1/omega besides: only where there is a
/// caisson, whose F_T is what must not move, and where nobody looks at the pressure.
FlowChoice choose_flow(const Region& region, const Surroundings& at, const Scene& scene);

struct CompressibilityChoice {
  Compressibility compressibility = Compressibility::compressible;
  std::string reason;
};

/// Free water is incompressible where omega h / c is small, h its depth and c the speed of sound, and where it has a
/// level to give way at.
CompressibilityChoice choose_compressibility(const Region& region, const Surroundings& at, const Scene& scene);

struct DeformationChoice {
  Deformation deformation = Deformation::elastic;
  std::string reason;
};

/// A solid moves as a rigid body where it is much stiffer than all that it touches and shear waves cross it within a
/// small part of the loads' duration; where nothing holds it and nothing is read inside it.
DeformationChoice choose_deformation(const Region& region, const Surroundings& at, const Scene& scene);

}  // namespace upbead
