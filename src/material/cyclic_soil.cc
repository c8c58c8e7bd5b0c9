#include "material/cyclic_soil.h"

#include <algorithm>
#include <cmath>

namespace upbead {

namespace {

constexpr double most_counted = 1e4;  ///< half cycles that are taken one by one

}  // namespace

double CyclicStrength::cycles_to_liquefy(double stress_ratio) const {
  return stress_ratio > 0. ? std::pow(stress_ratio / alpha, 1. / beta) : HUGE_VAL;
}

double pressure_of_cycle(const CyclicStrength& soil, double shear, double effective_stress) {
  return effective_stress / std::max(soil.cycles_to_liquefy(shear / effective_stress), 1.);
}

double compaction_after(const ShearCompaction& law, double amplitude, double cycles, double so_far) {
  if (!(law.of_half_cycle(amplitude, so_far) > 0.)) return so_far;
  const double half_cycles = 2. * cycles, counted = std::min(half_cycles, most_counted);
  for (double done = 0.; done < counted; done += 1.)
    so_far += std::min(counted - done, 1.) * law.of_half_cycle(amplitude, so_far);
  const double left = half_cycles - counted;
  if (left <= 0. || law.c2 == 0.) return so_far + left * law.of_half_cycle(amplitude, so_far);
  // exp(C2 eps/gamma) grows by C1 C2/2 in a half cycle
  return so_far +
         amplitude / law.c2 * std::log1p(0.5 * law.c1 * law.c2 * left * std::exp(-law.c2 * so_far / amplitude));
}

}  // namespace upbead
