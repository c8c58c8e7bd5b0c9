// What differs from cell to cell of a soil.
#pragma once

#include <vector>

namespace upbead {

/// By active cell index; a list without entries, or 0 in it, leaves the region's own value.
struct SoilState {
  std::vector<double> shear_modulus;  ///< G (Pa)
  std::vector<double> damping_ratio;  ///< at the region's two frequencies
};

}  // namespace upbead
