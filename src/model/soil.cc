#include "upbead/model/soil.h"

#include <algorithm>
#include <cmath>

namespace upbead {

double shear_modulus(const StressLaw& law, double stress, double floor) {
  return law.reference * std::pow(std::max(stress, floor) / law.pressure, law.exponent);
}

}  // namespace upbead
