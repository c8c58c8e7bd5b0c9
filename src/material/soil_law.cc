#include "material/soil_law.h"

#include <cmath>

#include "base/numbers.h"
#include "material/asked_law.h"
#include "material/hysteretic_law.h"
#include "material/mohr_coulomb_law.h"

namespace upbead {

double MohrCoulombStrength::shear(double mean) const {
  const double phi = friction_angle * (pi / 180.);
  return cohesion * std::cos(phi) + mean * std::sin(phi);
}

const std::vector<const SoilLawRow*>& soil_law_rows() {
  static const std::vector<const SoilLawRow*> rows{&hysteretic_row, &mohr_coulomb_row, &asked_row};
  return rows;
}

}  // namespace upbead
