// The expected sliding distance of a sea state by quadrature, after Shimosako and Takahashi (1994).
#pragma once

#include "upbead/expected/sliding_law.h"

namespace upbead {

struct Expectation {
  double distance = 0.;       ///< N int S(H) p(H) dH (m)
  double error = 0.;          ///< estimate of its error (m)
  double sliding_waves = 0.;  ///< expected number of waves with S > 0
  double threshold = 0.;      ///< height from which S > 0 (m); infinity where there is none
};

/// How hard to try.
struct QuadratureChoice {
  double tolerance = 1e-9;  ///< relative, of a sea state's distance
  unsigned depth = 14;      ///< how often an interval may be halved
};

/// Adaptive Gauss-Kronrod quadrature (Boost) from the height where sliding begins to that which 1e-18 of the sliding
/// waves exceed, or to the cut.
Expectation expected_distance(const SlidingLaw& law, const RayleighHeights& heights, double waves,
                              const QuadratureChoice& choice = {});

}  // namespace upbead
