#include "upbead/waves/breaking_impact.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"

namespace upbead {

double relative_impact(const ImpactScatter& s, double quantile) {
  return s.location + s.scale / s.shape * (1. - std::pow(-std::log(quantile), s.shape));
}

double relative_rise(const ImpactScatter& s) {
  if (!s.rise_quantile) return 1.;
  const double variance = std::log1p(s.rise_scatter * s.rise_scatter);
  const double z = boost::math::quantile(boost::math::normal(), *s.rise_quantile);
  return std::exp(std::sqrt(variance) * z - 0.5 * variance);
}

double equivalent_berm(const ImpactScatter& scatter, const Section& s) {
  return s.berm_width + 0.5 * std::max(s.water_depth - s.berm_depth, 0.) * scatter.mound_slope;
}

double breaker_on_wall(const ImpactScatter& scatter, const Section& s, double wavelength) {
  if (scatter.breaker) return *scatter.breaker;
  constexpr double square = 0.0076, linear = 0.1402;
  const double berm = std::min(equivalent_berm(scatter, s) / s.berm_depth, 0.5 * linear / square);
  const double k_b = square * berm * berm - linear * berm + 1., C_r = scatter.reflection;
  return (0.1025 + 0.0217 * (1. - C_r) / (1. + C_r)) * wavelength *
         std::tanh(k_b * two_pi * s.water_depth / wavelength);
}

double breaker_before_wall(const Section& s, double wavelength) {
  return 0.1242 * wavelength * std::tanh(two_pi * s.water_depth / wavelength);
}

BreakingImpact breaking_impact(const ImpactScatter& scatter, const Section& s, const Water& water,
                               const DesignWave& wave, double wavelength) {
  const double unit_weight = water.density * water.gravity, h = s.water_depth, Hs = wave.significant_height;
  BreakingImpact a;
  a.relative_mound = (h - s.berm_depth) / h;
  a.relative_height = Hs / h;
  a.relative_berm = equivalent_berm(scatter, s) / wavelength;
  a.breaker = breaker_on_wall(scatter, s, wavelength);
  a.breaker_before = breaker_before_wall(s, wavelength);
  // exceedance of Rayleigh's distribution, exp(-2 (H/H_1/3)^2)
  const auto higher = [Hs](double height) { return std::exp(-2. * (height / Hs) * (height / Hs)); };
  a.share = std::max(higher(a.breaker) - higher(a.breaker_before), 0.);
  a.breaks = wave.height >= a.breaker;
  a.relative_peak = relative_impact(scatter, scatter.quantile);
  const double scale = unit_weight * a.breaker * a.breaker;
  a.peak = a.relative_peak * scale;
  a.median_peak = relative_impact(scatter, 0.5) * scale;
  if (a.relative_height > 0.35 && a.relative_height < 0.6)
    a.sr443 = 15. * unit_weight * h * h * std::pow(a.relative_height, 3.134);
  return a;
}

namespace {

/// What the parameter map of PROVERBS calls such waves, by h_b*, H_s* and B*; its limits are from memory, and no number
/// depends on it.
std::string by_the_map(const BreakingImpact& a) {
  const double mound = a.relative_mound, height = a.relative_height, berm = a.relative_berm;
  if (mound < 0.3) return height < 0.35 ? "quasi-standing" : "slightly breaking";
  if (mound < 0.6) return height < 0.2 ? "quasi-standing" : "slightly breaking";
  if (mound >= 0.9 || berm > 0.4) return "broken before the wall";
  return height < 0.25 || berm < 0.12 ? "slightly breaking" : "impacts";
}

}  // namespace

std::string text_of(const ImpactScatter& scatter, const BreakingImpact& a) {
  const std::string heights = "H_b = " + significant(a.breaker) + " m" +
                              (scatter.breaker ? " (given)" : " by mound and L") + ", " + significant(100. * a.share) +
                              " % of the waves break there; waves of this sea are " + by_the_map(a) +
                              " by the parameter map, its limits assumed";
  if (!a.breaks)
    return "no impact: H is below H_b, from which a wave breaks on the wall (" + heights +
           "): the peak is Goda's P; PROVERBS (Oumeraci et al. 2001), its numbers assumed";
  return "impact: F* rho g H_b^2 with F* = " + significant(a.relative_peak) + ", the " +
         significant(100. * scatter.quantile) + " % quantile of generalised extreme values " +
         significant(scatter.location) + ", " + significant(scatter.scale) + ", " + significant(scatter.shape) + " (" +
         heights + "); PROVERBS (Oumeraci et al. 2001), its numbers assumed";
}

}  // namespace upbead
