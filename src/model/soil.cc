#include "upbead/model/region.h"

#include <algorithm>
#include <cmath>

namespace upbead {

double shear_modulus(const StressLaw& law, double stress, double floor) {
  return law.reference * std::pow(std::max(stress, floor) / law.pressure, law.exponent);
}

namespace {

/// Straight over the logarithm of the strain, constant beyond the ends.
double interpolate(const std::vector<std::array<double, 2>>& table, double strain) {
  if (strain <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 1; i < table.size(); ++i)
    if (strain < table[i][0]) {
      const double part = std::log(strain / table[i - 1][0]) / std::log(table[i][0] / table[i - 1][0]);
      return (1. - part) * table[i - 1][1] + part * table[i][1];
    }
  return table.back()[1];
}

}  // namespace

double modulus_ratio(const StrainLaw& law, double strain) {
  if (!law.modulus.empty()) return interpolate(law.modulus, strain);
  return 1. / (1. + strain / law.reference_strain);
}

double damping_ratio(const StrainLaw& law, double strain) {
  if (!law.damping.empty()) return interpolate(law.damping, strain);
  return law.smallest_damping + (law.largest_damping - law.smallest_damping) * (1. - modulus_ratio(law, strain));
}

}  // namespace upbead
