// A caisson that may slip on a mound that sways: one mass on another mass with a spring and a dashpot.
#pragma once

#include "upbead/sliding/block.h"

namespace upbead {

/// The sway of the ground, as a mass on a spring and a dashpot. Without a mass it must not have a dashpot either.
struct ElasticBase {
  double mass = 0.;       ///< that moves with the bottom (kg/m)
  double stiffness = 0.;  ///< k (N/m2)
  double damping = 0.;    ///< c (N s/m2)
};

struct ElasticSliding {
  Sliding slip;                   ///< of the caisson over its base
  double peak_shear = 0.;         ///< largest |F_T|, found at the samples (N/m)
  double peak_displacement = 0.;  ///< largest |x| of the caisson, at the samples (m)
};

/// m x'' = P - F_T and m_b y'' + c y' + k y = F_T from rest. Stuck, x - y keeps its value and |F_T| <= R; slipping,
/// F_T = R sgn(x' - y'). Between the points of P both phases are solved exactly. A change of phase is looked for 60
/// times in the shortest of their periods and in every piece, and found as a root, so that only changes undone within
/// such a part are missed. Agrees with ref7 B and C to their nine digits.
/// - mass: m of the caisson (kg/m); force: P, zero before and after its points (N/m); resistance: R (N/m).
/// Throws std::invalid_argument where mass, stiffness or resistance is not positive, or a history is wrong.
ElasticSliding slide_on_base(double mass, const ElasticBase& base, const History& force, double resistance);

}  // namespace upbead
