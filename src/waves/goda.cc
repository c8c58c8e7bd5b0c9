#include "upbead/waves/goda.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/constants.h"
#include "require_positive.h"
#include "upbead/waves/dispersion.h"
#include "upbead/waves/impulsive.h"

namespace upbead {

namespace {

/// lambda_1 = lambda_3 of a wall behind wave-dissipating blocks, after Takahashi, Tanimoto and Shimosako (1990). The
/// numbers have not been checked in the original, which is why a section may bring its own.
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
  const double head = 0.5 * (1. + cos_angle_) * unit_weight_ * height;  // what all pressures are multiples of
  p.eta_star = 0.75 * (1. + cos_angle_) * p.lambda_1 * height;
  p.p1 = head * (p.lambda_1 * p.alpha_1 + p.lambda_2 * beside_alpha_1 * cos_angle_ * cos_angle_);
  p.p3 = alpha_3_ * p.p1;
  p.p4 = p.eta_star > section_.crest ? p.p1 * (1. - section_.crest / p.eta_star) : 0.;
  p.pu = head * p.lambda_3 * p.alpha_1 * alpha_3_;
  add_resultants(section_, p);
  return p;
}

}  // namespace upbead
