// Sand under cycles of shear in the course of a storm: cycles until it liquefies, and how much denser it packs.
#pragma once

#include "material/densification.h"

namespace upbead {

/// De Alba, Seed and Chan (1976): N cycles of amplitude tau liquefy the soil where tau/sigma'_0 = alpha N^beta, beta <
/// 0.
struct CyclicStrength {
  double alpha = 0., beta = 0.;
  /// N_l = (tau/(alpha sigma'_0))^(1/beta); infinite where there is no shear.
  double cycles_to_liquefy(double stress_ratio) const;
};

/// Seed and Rahman (1978): pore pressure that one cycle makes where no water leaves, sigma'_0 / N_l (Pa). N_l counts as
/// 1 at least: the curve was measured from some cycles on, and one cycle builds no more than the whole sigma'_0.
double pressure_of_cycle(const CyclicStrength& soil, double shear, double effective_stress);

/// eps_v after more cycles of one amplitude: ShearCompaction::of_half_cycle, half cycle by half cycle. Beyond 10^4 half
/// cycles in closed form, d eps_v/dn = of_half_cycle, whose error is then below 1e-4.
double compaction_after(const ShearCompaction& law, double amplitude, double cycles, double so_far);

}  // namespace upbead
