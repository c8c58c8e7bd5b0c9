// Impulsive forces of waves that break on an upright wall, in the manner of PROVERBS: Oumeraci et al. (2001),
// Probabilistic Design Tools for Vertical Breakwaters; Klammer, Kortenhaus and Oumeraci (1996), 25th ICCE; Allsop,
// Vicinanza and McKenna (1996), HR Wallingford SR 443. The books were not at hand: their numbers are assumptions, each
// of them an input, and are told as such.
#pragma once

#include <optional>
#include <string>

#include "upbead/waves/goda.h"

namespace upbead {

/// What is assumed of an impact on the wall.
struct ImpactScatter {
  double quantile = 0.9;  ///< share of the impacts whose peak is lower
  /// F* = F/(rho g H_b^2) of the largest force of an impact, as generalised extreme values: F* = location + scale/shape
  /// (1 - (-ln quantile)^shape). On a bed of 1:50.
  double location = 3.268, scale = 1.91, shape = -0.232;
  std::optional<double> rise_quantile;  ///< share of the impacts that rise faster than at this F*; none: the mean rise
  double rise_scatter = 0.977;          ///< standard deviation of that rise over its mean, lognormal
  double reflection = 0.9;              ///< C_r of the wall
  double mound_slope = 1.5;             ///< cotangent of the mound's seaward slope
  std::optional<double> breaker;        ///< H_b (m); none: by breaker_on_wall()
};

/// F* that a share `quantile` of the impacts does not exceed. shape != 0, 0 < quantile < 1.
double relative_impact(const ImpactScatter& scatter, double quantile);

/// The rise of that quantile over the mean rise: exp(sigma z - sigma^2/2), sigma^2 = ln(1 + rise_scatter^2), z the
/// standard normal quantile; 1 where no quantile is given.
double relative_rise(const ImpactScatter& scatter);

/// B_eq = B_M + (h - d) cot/2 (m).
double equivalent_berm(const ImpactScatter& scatter, const Section& section);

/// H_b (m), from which a wave breaks on the wall: (0.1025 + 0.0217 (1 - C_r)/(1 + C_r)) L tanh(2 pi k_b h/L), k_b =
/// 0.0076 (B_eq/d)^2 - 0.1402 B_eq/d + 1 while that falls. Or the height that is given.
double breaker_on_wall(const ImpactScatter& scatter, const Section& section, double wavelength);
/// 0.1242 L tanh(2 pi h/L) (m), from which it breaks before.
double breaker_before_wall(const Section& section, double wavelength);

/// A wave's impact on a section.
struct BreakingImpact {
  double relative_mound = 0., relative_height = 0., relative_berm = 0.;  ///< (h - d)/h, H_1/3/h, B_eq/L
  double breaker = 0., breaker_before = 0.;                              ///< m
  double share = 0.;                                       ///< of the waves of the sea that break on the wall; Rayleigh
  bool breaks = false;                                     ///< whether H is at least `breaker`
  double relative_peak = 0., peak = 0., median_peak = 0.;  ///< F* at the quantile, and forces (N/m)
  std::optional<double> sr443;  ///< F_1/250 = 15 rho g h^2 (H_1/3/h)^3.134, for 0.35 < H_1/3/h < 0.6 (N/m)
};

BreakingImpact breaking_impact(const ImpactScatter& scatter, const Section& section, const Water& water,
                               const DesignWave& wave, double wavelength);

/// Where the force comes from, in words.
std::string text_of(const ImpactScatter& scatter, const BreakingImpact& impact);

}  // namespace upbead
