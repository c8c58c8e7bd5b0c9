// Chooses what a case leaves open in a region, by dimensionless numbers. A choice stated in the case is always kept.
// The limits are measured: docs/skipping.md.
#pragma once

#include <string>
#include <vector>

#include "upbead/model/scene.h"

namespace upbead {

/// What a choice needs to know about a region's place in the mesh.
struct Surroundings {
  double height = 0.;                ///< of the region (m)
  double width = 0.;                 ///< of the region (m)
  bool has_open_side = false;        ///< one of its outer sides has pressure open or surface_waves
  bool is_held = false;              ///< one of its outer sides is fixed, on rollers or absorbing
  bool has_load = false;             ///< a pressure acts on one of its outer sides, or on its pore water
  bool has_probe = false;            ///< it has a probe, or fields are asked for
  bool touches_water = false;        ///< it touches free water
  std::vector<std::string> touches;  ///< other regions that it touches
};

/// Why a region's pore water is treated as it is.
struct FlowChoice {
  Flow flow = Flow::darcy;
  double X = 0.;       ///< k omega / (g n), ratio of fluid inertia to drag; 0 without a load
  std::string reason;  ///< a sentence for the report, with the number
};

/// Darcy where X [Zienkiewicz, Chang and Bettess 1980] is small up to the end of the loads' spectrum, omega =
/// bandwidth(scene), inertial above. Drained where, in addition, the pressure leaves within 1/omega: only where there
/// is a caisson, as the choice must not change its F_T, and where no pressure is read.
FlowChoice choose_flow(const Region& region, const Surroundings& at, const Scene& scene);

struct CompressibilityChoice {
  Compressibility compressibility = Compressibility::compressible;
  std::string reason;
};

/// Free water is incompressible where omega h / c is small, h its depth and c the speed of sound, and where it has an
/// open level at which it can give way.
CompressibilityChoice choose_compressibility(const Region& region, const Surroundings& at, const Scene& scene);

struct DeformationChoice {
  Deformation deformation = Deformation::elastic;
  std::string reason;
};

/// A solid moves as a rigid body where it is much stiffer than all regions that it touches and shear waves cross it
/// within a small part of the loads' duration; and only where none of its sides is held and nothing is read inside
/// it.
DeformationChoice choose_deformation(const Region& region, const Surroundings& at, const Scene& scene);

}  // namespace upbead
