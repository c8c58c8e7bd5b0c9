// By which factor the strength of the ground may fall while a caisson presses on it as at a moment of a wave.
#pragma once

#include <array>
#include <vector>

#include "fem/rest_state.h"
#include "fem/space.h"

namespace upbead {

/// What the base of a caisson presses on the ground with: N' and F_T (N/m) at its middle, and M' about that,
/// overturning landward positive (N m/m).
struct BaseForces {
  double normal = 0., shear = 0., moment = 0.;
  dealii::Point<dim> middle;  ///< of the base (m)
  double width = 0.;          ///< m
};

/// What acts on the ground at a moment, besides the weights of soils and surcharges.
struct LoadedMoment {
  BaseForces base;
  const Space* pores = nullptr;  ///< of the pore pressure; none where it is that of still water
  Vector pressure;               ///< excess, at the degrees of freedom of phi of that space (Pa)
};

struct LoadedSafety : SafetyFactor {
  std::size_t moment = 0;  ///< the worst
  std::string moves;       ///< "turns landward": how the base moves as the ground fails; "" where it does not fail
  std::array<double, 2> centre{0., 0.};  ///< about which it turns then (m)
  std::optional<double> depth;           ///< below the base, above which 95 % of the work of shearing is done (m)
};

/// Strength reduction as safety_factor(), under the worst of the moments: the first is sought to 0.5 %, and each other
/// one only where the ground does not rest under it at the factor found so far. The caisson is a rigid body on
/// the ground, bonded to it; the ground itself has no inertia, and what acts on it besides is left out. `guess`: of the
/// factor.
LoadedSafety safety_factor_under(const std::vector<LoadedMoment>& moments, const Scene& scene, const Mesh& mesh,
                                 const SoilState& soil, double guess, const RestProgress& progress = {});

}  // namespace upbead
