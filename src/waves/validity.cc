#include "upbead/waves/goda.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "base/text.h"
#include "upbead/waves/wave_heights.h"
#include "waves/section_warnings.h"

namespace upbead {

namespace {

/// A wave before its wall, as all checks below use it.
struct CheckedWave {
  const Section& section;
  const Water& water;
  const DesignWave& wave;
  const WavePressure& pressure;
  double L, L0;  // m
};

std::string metres(double value) {
  return significant(value, 4) + " m";
}

/// Where Deltares' coastal-structures-toolbox 1.0.0 says that Goda's formulas do not apply: waves that break on a
/// steep bed, and waves that break on a high mound. The toolbox takes H_0'/L_0; here H_1/3 at the wall over L_0 is
/// used.
bool may_break_impulsively(const CheckedWave& s) {
  const double angle = s.wave.angle / boost::math::constants::degree<double>();
  const double berm = s.section.berm_width / s.L, Hs = s.wave.significant_height;
  if (angle >= 20. || s.section.crest / Hs <= 0.3) return false;
  const bool on_the_bed = berm < 0.02 && s.section.bed_slope > 1. / 50. && Hs / s.L0 < 0.03;
  const bool on_the_mound = berm > 0.02 && berm < 0.3 && s.section.berm_depth / s.section.water_depth < 0.6;
  return on_the_bed || on_the_mound;
}

void judge_wave(const CheckedWave& s, NumberedWarnings& list) {
  const double H = s.wave.height, h = s.section.water_depth;
  if (may_break_impulsively(s))
    list.push_back({"impulsive_breaking", 0., 0., "",
                    "waves may break on the wall (B_M/L = " + significant(s.section.berm_width / s.L) +
                        ", d/h = " + significant(s.section.berm_depth / h) +
                        "): Goda's formula alone does not hold, alpha_I is made for it but the scatter is large",
                    "compare with tests of such a section before the force is believed"});
  if (H > 0.8 * h)
    list.push_back({"height_over_depth", H / h, 0.8, "1",
                    "H/h = " + significant(H / h) + " is beyond 0.8, where eq. (11) for tau_0F ends; 0.4 T is used",
                    "check height and water_depth, or take sliding distances as rough"});
  constexpr double impossible = 2.;  // beyond any scatter of that limit, period or height is another number
  // Miche (1944): the steepest progressive wave at that depth.
  const double limit = 0.142 * s.L * std::tanh(boost::math::constants::two_pi<double>() * h / s.L);
  if (H > limit)
    list.push_back({"breaking_limit", H, limit, "m",
                    "H = " + metres(H) + " is above Miche's limit of breaking at the wall, " + metres(limit) +
                        ": such a wave breaks before",
                    "give a height of at most " + metres(limit) + ", or check period and water_depth",
                    H > impossible * limit});
  if (s.wave.significant_height >= H)
    list.push_back({"significant_height", s.wave.significant_height, H, "m",
                    "H_1/3 = " + metres(s.wave.significant_height) + " is not below H = " + metres(H) +
                        ", which is to be the highest wave",
                    "check height and significant_height (H mostly is 1.8 H_1/3)"});
  // by Rayleigh's distribution one wave in e^32 = 8e13 is higher than 4 H_1/3 (Longuet-Higgins 1952)
  if (s.wave.significant_height < H / 4.)
    list.push_back({"significant_height", s.wave.significant_height, H / 4., "m",
                    "H_1/3 = " + metres(s.wave.significant_height) + " is less than a quarter of H = " + metres(H) +
                        ": no sea has so high a wave, and P is found too near the wall",
                    "check height and significant_height (H mostly is 1.8 H_1/3)"});
  if (s.wave.period > 30.)
    list.push_back({"long_period", s.wave.period, 30., "s",
                    "T = " + significant(s.wave.period, 4) + " s is longer than 30 s, where the tests end",
                    "check the period, or compare with tests of so long waves"});
}

/// The usual mistake is kN for N, or W in place of W'; a footing or rounded corners change the buoyancy by less than
/// a fifth. A W' above what the width leaves of W is a safety that is not: told, and voids, from where a run does.
void judge_weight(const Section& c, const Water& water, NumberedWarnings& list) {
  const double given = c.weight - c.submerged_weight;
  const double displaced = water.density * water.gravity * c.foundation_depth * c.width;
  const double in_water = std::abs(c.weight - displaced), excess = displaced - given;
  constexpr double unsafe = 0.02, void_above = 0.1;
  const bool far = std::abs(given - displaced) > 0.2 * displaced || excess > void_above * in_water;
  if (far || excess > unsafe * in_water)
    list.push_back({"buoyancy", given, displaced, "N/m",
                    "W - W' = " + significant(given, 4) +
                        " N/m, but a caisson of width B displaces rho g h' B = " + significant(displaced, 4) + " N/m",
                    "check the units of weight and submerged_weight (N/m), and which of them is in water", far});
}

void judge_section(const Section& c, NumberedWarnings& list) {
  if (c.bed_slope > 0.1 || c.bed_slope < 0.01)
    list.push_back({"bed_slope", c.bed_slope, c.bed_slope > 0.1 ? 0.1 : 0.01, "1",
                    "tan(theta) = " + significant(c.bed_slope) + " is outside 0.01 to 0.1, where the tests are",
                    "check bed_slope (a tangent, not percent), or compare with tests of such a bed"});
  if (c.berm_depth > c.water_depth)
    list.push_back({"berm_below_bed", c.berm_depth, c.water_depth, "m",
                    "d = " + metres(c.berm_depth) + " is below the bed at h = " + metres(c.water_depth),
                    "check berm_depth and water_depth (both from still water down)", true});
  if (c.foundation_depth > c.water_depth)
    list.push_back({"foundation_below_bed", c.foundation_depth, c.water_depth, "m",
                    "h' = " + metres(c.foundation_depth) + " is below the bed at h = " + metres(c.water_depth) +
                        ", where alpha_3 was not made for",
                    "check foundation_depth and water_depth (both from still water down)"});
}

void judge_pressure(const CheckedWave& s, double depth_b, NumberedWarnings& list) {
  const WavePressure& p = s.pressure;
  if (depth_b <= s.section.berm_depth)
    list.push_back({"alpha_2_clamped", depth_b, s.section.berm_depth, "m",
                    "h_b = " + metres(depth_b) + " is not below the berm, d = " + metres(s.section.berm_depth) +
                        ": alpha_2 would be negative, 0 is used",
                    "check berm_depth, water_depth and bed_slope"});
  if (p.alpha_3 <= 0.)
    list.push_back({"alpha_3_clamped", p.alpha_3, 0., "1",
                    "h' = " + metres(s.section.foundation_depth) + " at h = " + metres(s.section.water_depth) +
                        ": alpha_3 would be negative, 0 is used",
                    "check foundation_depth and water_depth"});
  if (p.alpha_I < 0.)
    list.push_back(
        {"alpha_I_negative", p.alpha_I, 0., "1",
         "alpha_I = " + significant(p.alpha_I) + " is negative, as on low mounds: no impulsive pressure, alpha_2 rules",
         "check berm_depth and berm_width where a high mound is meant"});
  if (p.eta_star <= s.section.crest)
    list.push_back({"eta_star_below_crest", p.eta_star, s.section.crest, "m",
                    "eta* = " + metres(p.eta_star) +
                        " does not rise above the crest, h_c = " + metres(s.section.crest) + ": p4 = 0",
                    "check crest where the wave is to overtop"});
  const double safety = stability(s.section, p, still_water(s.section, s.water)).safety_overturning;
  if (p.uplift < s.section.submerged_weight && safety < 1.)
    list.push_back({"overturns", safety, 1., "1",
                    "the safety factor against overturning is " + significant(safety) +
                        ": the caisson tilts, and a formula for sliding knows nothing of that",
                    "widen the caisson, or make it heavier"});
  if (p.uplift >= s.section.submerged_weight)
    list.push_back({"lifted", p.uplift, s.section.submerged_weight, "N/m",
                    "U is not below W': the caisson floats up, and no safety factor means anything",
                    "make the caisson heavier, or check submerged_weight"});
}

}  // namespace

NumberedWarnings section_warnings(const Section& section, const Water& water) {
  NumberedWarnings list;
  judge_section(section, list);
  judge_weight(section, water, list);
  return list;
}

NumberedWarnings warnings(const Section& section, const Water& water, const DesignWave& wave,
                          const WavePressure& pressure) {
  const CheckedWave s{section,
                      water,
                      wave,
                      pressure,
                      wavelength(wave.period, section.water_depth, water.gravity),
                      deep_water_wavelength(wave.period, water.gravity)};
  NumberedWarnings list;
  judge_wave(s, list);
  append(list, section_warnings(section, water));
  judge_pressure(s, section.water_depth + 5. * wave.significant_height * section.bed_slope, list);
  return list;
}

}  // namespace upbead
