// What differs from cell to cell of a soil.
#pragma once

#include <vector>

namespace upbead {

/// By active cell index; a list without entries, 0 as G or a negative damping leaves the region's own value.
struct SoilState {
  std::vector<double> shear_modulus;  ///< G (Pa)
  std::vector<double> damping_ratio;  ///< of regions with damping, at their two frequencies
};

}  // namespace upbead
