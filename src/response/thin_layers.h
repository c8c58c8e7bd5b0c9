// Soft layers under the caisson that are thin, and how finely they are meshed along.
#pragma once

#include <string>
#include <vector>

#include "fem/compile.h"

namespace upbead {

/// A region that is thinner than a quarter of the caisson's width, and at most a fifth as stiff as the stiffest ground:
/// it is sheared and squeezed as a film, and what happens at the film's ends decays within about its own thickness.
struct ThinLayer {
  std::string region;
  double thickness = 0.;  ///< mean over what of it lies below the caisson and half its width beside it (m)
  double longest = 0.;    ///< horizontal extent of the longest cell there (m)
  double contrast = 1.;   ///< of the stiffest ground's shear modulus over its own; infinite where it is all ground
  double cells_per_thickness() const { return thickness / longest; }
};

/// By name. Needs a caisson.
std::vector<ThinLayer> thin_layers(const Space& space, const Caisson& caisson);

}  // namespace upbead
