#include "upbead/waves/goda.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "require_positive.h"
#include "upbead/waves/edge_pressures.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

namespace {

/// lambda_1 = lambda_3 of a wall behind wave-dissipating blocks, after Takahashi, Tanimoto and Shimosako (1990). The
/// numbers have not been checked in the original; therefore a section may give its own.
double behind_blocks(double height_over_depth) {
  if (height_over_depth <= 0.3) return 1.;
  return height_over_depth <= 0.6 ? 1.2 - 2. / 3. * height_over_depth : 0.8;
}

/// P, M_P, U, M_U of the pressures: trapezia over h' and over h_c*, a triangle over B [Goda 2000].
void add_resultants(const Section& s, WavePressure& p) {
  const double h = s.foundation_depth, top = std::min(p.eta_star, s.crest);
  p.force = 0.5 * (p.p1 + p.p3) * h + 0.5 * (p.p1 + p.p4) * top;
  p.force_moment =
      (2. * p.p1 + p.p3) * h * h / 6. + 0.5 * (p.p1 + p.p4) * h * top + (p.p1 + 2. * p.p4) * top * top / 6.;
  p.uplift = 0.5 * p.pu * s.width;
  p.uplift_moment = 2. / 3. * p.uplift * s.width;
}

}  // namespace

Goda::Goda(const Section& section, const Water& water, const DesignWave& wave)
    : section_(section), unit_weight_(water.density * water.gravity), cos_angle_(std::cos(wave.angle)) {
  require_positive(section.water_depth, "water depth", "Goda\'s formulas need");
  require_positive(section.foundation_depth, "foundation depth", "Goda\'s formulas need");
  require_positive(section.berm_depth, "berm depth", "Goda\'s formulas need");
  require_positive(wave.significant_height, "significant height", "Goda\'s formulas need");
  const double h = section.water_depth;
  const double kh = relative_wave_number(wave.period, h, water.gravity);
  wavelength_ = two_pi * h / kh;
  depth_b_ = h + 5. * wave.significant_height * section.bed_slope;
  // sinh and cosh may be infinite in deep water: both terms then vanish.
  const double shallow = 2. * kh / std::sinh(2. * kh);
  alpha_1_ = 0.6 + 0.5 * shallow * shallow;
  // Negative only where the caisson's bottom is far below the bed.
  alpha_3_ = std::max(1. - section.foundation_depth / h * (1. - 1. / std::cosh(kh)), 0.);
  alpha_I1_ = alpha_I1(section.berm_width / wavelength_, (h - section.berm_depth) / h);
}

double Goda::alpha_2(double height) const {
  const double d = section_.berm_depth, relative = height / d;
  const double mound = (depth_b_ - d) / (3. * depth_b_);
  return std::max(std::min(mound * relative * relative, 2. / relative), 0.);
}

WavePressure Goda::at(double height, PressureFormula formula) const {
  WavePressure p;
  p.alpha_1 = alpha_1_;
  p.alpha_2 = alpha_2(height);
  p.alpha_3 = alpha_3_;
  p.alpha_I = alpha_I0(height, section_.berm_depth) * alpha_I1_;
  p.alpha_star = std::max(p.alpha_2, p.alpha_I);
  if (section_.dissipating_blocks) {
    p.lambda_1 = p.lambda_3 = behind_blocks(height / section_.water_depth);
    p.lambda_2 = 0.;
  }
  p.lambda_1 = section_.lambda_1.value_or(p.lambda_1);
  p.lambda_2 = section_.lambda_2.value_or(p.lambda_2);
  p.lambda_3 = section_.lambda_3.value_or(p.lambda_3);

  const double beside_alpha_1 = formula == PressureFormula::extended ? p.alpha_star
                                : formula == PressureFormula::goda   ? p.alpha_2
                                                                     : 0.;
  const double head = 0.5 * (1. + cos_angle_) * unit_weight_ * height;  // common factor of all pressures
  p.eta_star = 0.75 * (1. + cos_angle_) * p.lambda_1 * height;
  p.p1 = head * (p.lambda_1 * p.alpha_1 + p.lambda_2 * beside_alpha_1 * cos_angle_ * cos_angle_);
  p.p3 = alpha_3_ * p.p1;
  p.p4 = p.eta_star > section_.crest ? p.p1 * (1. - section_.crest / p.eta_star) : 0.;
  p.pu = head * p.lambda_3 * p.alpha_1 * alpha_3_;
  add_resultants(section_, p);
  return p;
}

Diagnostics diagnose(const Section& s) {
  Diagnostics list;
  if (s.submerged_weight >= s.weight)
    list.add(at_key("submerged_weight"),
             "submerged_weight = " + significant(s.submerged_weight, 6) +
                 " N/m is not below weight = " + significant(s.weight, 6) + " N/m",
             "give W' in still water, W less the weight of the displaced water");
  if (s.centroid && *s.centroid >= s.width)
    list.add(at_key("centroid"),
             "centroid = " + significant(*s.centroid, 6) +
                 " m lies outside the caisson, width = " + significant(s.width, 6) + " m",
             "give the distance from the landward heel to the line of W' (m)");
  if (s.harbour_level > s.crest)
    list.add(at_key("harbour_level"),
             "harbour_level = " + significant(s.harbour_level, 6) +
                 " m is above the crest = " + significant(s.crest, 6) + " m",
             "give the height of the harbour's still water above that of the sea (m)");
  return list;
}

Section at_water_level(const Section& section, const Water& water, double rise) {
  Section s = section;
  s.water_depth += rise;
  s.foundation_depth += rise;
  s.berm_depth += rise;
  s.crest -= rise;
  const double under_water = std::clamp(rise, -section.foundation_depth, section.crest);
  const double buoyancy = water.density * water.gravity * section.width * under_water;
  s.submerged_weight -= buoyancy;
  // buoyancy of upright walls acts at B/2, not at t
  if (s.centroid && s.submerged_weight != 0.)
    s.centroid = (section.submerged_weight * *section.centroid - buoyancy * 0.5 * section.width) / s.submerged_weight;
  return s;
}

double alpha_I1(double berm_width_over_wavelength, double mound_height_over_depth) {
  const double x = berm_width_over_wavelength - 0.12, y = mound_height_over_depth - 0.6;
  const double delta_11 = 0.93 * x + 0.36 * y;
  const double delta_22 = -0.36 * x + 0.93 * y;
  const double delta_1 = (delta_11 <= 0. ? 20. : 15.) * delta_11;
  const double delta_2 = (delta_22 <= 0. ? 4.9 : 3.) * delta_22;
  // cosh may be infinite for a very wide berm: the coefficient then tends to 0, as it should.
  if (delta_2 <= 0.) return std::cos(delta_2) / std::cosh(delta_1);
  return 1. / (std::cosh(delta_1) * std::sqrt(std::cosh(delta_2)));
}

double alpha_I0(double height, double berm_depth) {
  return std::min(height / berm_depth, 2.);
}

StillWater still_water(const Section& section, const Water& water) {
  const double front = section.foundation_depth;
  return still_water(front, front + section.harbour_level, section.width, water.density * water.gravity);
}

TurnedAngle turned_angle(double direction, double facing) {
  constexpr double most_turned = 15.;  // degrees, Goda (2000)
  const double to_normal = std::abs(std::remainder(direction - facing, 360.));
  return {to_normal, std::max(to_normal - most_turned, 0.)};
}

Stability stability(const Section& section, const WavePressure& pressure, const StillWater& still) {
  const double t = section.centroid.value_or(0.5 * section.width);
  const double push = std::max(still.push, 0.), moment = pressure.force_moment + std::max(still.push_moment, 0.);
  const double vertical = section.submerged_weight + still.weight - pressure.uplift;
  const double resisting = section.submerged_weight * t + still.weight * section.width / 3. - pressure.uplift_moment;
  Stability s;
  s.safety_sliding = section.friction * vertical / (pressure.force + push);
  s.safety_overturning = resisting / moment;
  // t_e = (W' t - M_U - M_P)/(W' - U) is the resultant's distance from the heel
  const double about_the_middle = 0.5 * section.width * vertical - (resisting - moment);
  if (vertical > 0.) s.heel_pressure = edge_pressures(vertical, about_the_middle, section.width).landward;
  s.sliding_force = pressure.force + section.friction * pressure.uplift;
  s.resistance = section.friction * (section.submerged_weight + still.weight) - push;
  s.ratio = s.sliding_force / s.resistance;
  s.force = pressure.force + push;
  s.moment = moment;
  return s;
}

double submerged_weight_for(double safety_sliding, double friction, const WavePressure& pressure) {
  return safety_sliding * pressure.force / friction + pressure.uplift;
}

double standing_duration(double height, double depth, double period) {
  return (0.5 - std::min(height / depth, 0.8) / 8.) * period;
}

double DurationFactor::operator()(double alpha_star) const {
  return 1. / std::pow(std::pow(std::max(alpha_star, 0.), a) + 1., b);
}

}  // namespace upbead
