// Wave pressure on the caisson after Goda (2000), extended by the impulsive pressure coefficient.
#pragma once

#include "upbead/waves/section.h"

namespace upbead {

/// Which coefficient stands beside alpha_1 in p_1.
enum class PressureFormula {
  goda,      ///< alpha_2, after Goda
  extended,  ///< alpha* = max(alpha_2, alpha_I), after Takahashi, Tanimoto and Shimosako (1994)
  standing,  ///< none: the standing-wave part of Shimosako and Takahashi (1998)
};

/// Pressures (Pa) and their resultants per metre. P landward; U upward; moments positive where they overturn.
struct WavePressure {
  double alpha_1 = 0., alpha_2 = 0., alpha_3 = 0.;
  double alpha_I = 0.;     ///< as its formula says; may be negative
  double alpha_star = 0.;  ///< max(alpha_2, alpha_I), never below 0; also the alpha* of k(alpha*), whatever the formula
  double lambda_1 = 1., lambda_2 = 1., lambda_3 = 1.;
  double eta_star = 0.;       ///< height of the pressure above still water (m)
  double p1 = 0.;             ///< at still water
  double p3 = 0.;             ///< at the caisson's bottom
  double p4 = 0.;             ///< at the caisson's top
  double pu = 0.;             ///< uplift at the seaward edge of the bottom, zero at the heel
  double force = 0.;          ///< P (N/m)
  double uplift = 0.;         ///< U (N/m)
  double force_moment = 0.;   ///< M_P, about the bottom's level (N m/m)
  double uplift_moment = 0.;  ///< M_U, about the heel (N m/m)
};

/// Goda's formulas for all heights of one sea state: what does not depend on H is found once, so that a wave costs some
/// hundred operations. Where h_b <= d alpha_2 would be negative and is 0; likewise alpha_3 where h' is far above h.
class Goda {
 public:
  /// `wave.height` is not used. Throws std::invalid_argument where a depth, the period or the significant height is
  /// not positive.
  Goda(const Section& section, const Water& water, const DesignWave& wave);
  /// H_D > 0 (m).
  WavePressure at(double height, PressureFormula formula = PressureFormula::extended) const;
  double wavelength() const { return wavelength_; }  ///< L at the depth h (m)
  double seaward_depth() const { return depth_b_; }  ///< h_b, 5 H_1/3 seaward of the wall (m)

 private:
  double alpha_2(double height) const;
  Section section_;
  double unit_weight_;  ///< rho g (N/m3)
  double cos_angle_;    ///< cos(beta)
  double wavelength_, depth_b_;
  double alpha_1_, alpha_3_, alpha_I1_;
};

}  // namespace upbead
