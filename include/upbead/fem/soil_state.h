// What differs from cell to cell of a soil.
#pragma once

#include <vector>

namespace upbead {

/// By active cell index; a list without entries, 0 as G or a negative damping leaves the region's own value.
struct SoilState {
  std::vector<double> shear_modulus;  ///< G (Pa)
  std::vector<double> damping_ratio;  ///< of regions with damping, at their two frequencies
  std::vector<double> pore_fluid;     ///< bulk modulus of pore water with its air (Pa); 0: that of the region
  std::vector<double> conductivity;   ///< k of horizontal flow, with drag that grows with velocity (m/s); 0: likewise
  bool varies() const {
    return !shear_modulus.empty() || !damping_ratio.empty() || !pore_fluid.empty() || !conductivity.empty();
  }
};

}  // namespace upbead
