// A caisson breakwater and its waves by the formulas of Goda (2000), extended by the impulsive pressure coefficient of
// Takahashi, Tanimoto and Shimosako (1994): pressures, safety, duration, and where all that holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/error.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/base/still_water.h"

namespace upbead {

/// Names and symbols of Goda (2000) and of Shimosako and Takahashi (1994).
struct Section {
  double water_depth = 0.;          ///< h, at the wall (m)
  double foundation_depth = 0.;     ///< h', still water to the caisson's bottom (m)
  double berm_depth = 0.;           ///< d, still water to the top of the armour of the mound (m)
  double crest = 0.;                ///< h_c, above still water (m)
  double width = 0.;                ///< B of the caisson (m)
  double berm_width = 0.;           ///< B_M, of the mound in front of the caisson (m)
  double bed_slope = 0.;            ///< tan(theta)
  double weight = 0.;               ///< W, in air with fill (N/m)
  double submerged_weight = 0.;     ///< W', in still water (N/m)
  std::optional<double> centroid;   ///< t, from the landward heel to the line of W' (m); none: B/2
  double friction = 0.6;            ///< mu
  bool dissipating_blocks = false;  ///< whether wave-dissipating blocks cover the wall
  /// Factors of alpha_1 in p_1, of the other coefficient in p_1, and of p_u; none: 1, or the value for
  /// `dissipating_blocks`.
  std::optional<double> lambda_1, lambda_2, lambda_3;
  double harbour_level = 0.;       ///< of still water behind the caisson above that of the sea (m); negative: lower
  std::optional<double> facing{};  ///< where the wall looks at, degrees from north: the chart's direction of its normal
};

/// Water and gravity.
struct Water {
  double density = 1030.;  ///< rho (kg/m3)
  double gravity = 9.81;   ///< g (m/s2)
};

constexpr double highest_over_significant = 1.8;  ///< H_max / H_1/3 outside the surf zone [Goda 2000]

/// One design wave, or the highest of a sea state.
struct DesignWave {
  double height = 0.;              ///< H_D (m)
  double significant_height = 0.;  ///< H_1/3 (m); h_b is the depth 5 H_1/3 seaward
  double period = 0.;              ///< T, the significant one (s)
  double angle = 0.;               ///< beta between wave and the wall's normal, already turned towards it (rad)
};

/// Every contradiction in a section: W' not below W, a centroid outside B. warnings() names what is only outside the
/// range of the formulas.
Diagnostics diagnose(const Section& section);

/// What still water does by the harbour_level of a section.
StillWater still_water(const Section& section, const Water& water);

/// beta (degrees) of a wave that comes from `direction` at a wall that looks at `facing`, both in degrees from north:
/// the angle to the wall's normal, and after it was turned by up to 15 degrees towards it, as Goda (2000) has it
/// because the direction of a design wave is not known better.
struct TurnedAngle {
  double to_normal = 0., turned = 0.;
};
TurnedAngle turned_angle(double direction, double facing);

/// The section when the still water stands `rise` higher (m; negative: lower): h, h', d and h_c change with it, and W'
/// falls by rho g B at B/2 for each metre of the caisson's walls that comes under water, and t with it. The harbour's
/// level rises with it.
Section at_water_level(const Section& section, const Water& water, double rise);

/// The coefficient that is added to alpha_1 in p_1.
enum class PressureFormula {
  goda,      ///< alpha_2, after Goda
  extended,  ///< alpha* = max(alpha_2, alpha_I), after Takahashi, Tanimoto and Shimosako (1994)
  standing,  ///< none: the standing-wave part of Shimosako and Takahashi (1998)
};

/// Pressures (Pa) and their resultants per metre. P landward; U upward; moments positive where they overturn.
struct WavePressure {
  double alpha_1 = 0., alpha_2 = 0., alpha_3 = 0.;
  double alpha_I = 0.;     ///< as its formula says; may be negative
  double alpha_star = 0.;  ///< max(alpha_2, alpha_I), at least 0; with every formula also the alpha* of k(alpha*)
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

/// Goda's formulas for all heights of one sea state: what does not depend on H is computed once, so that a wave costs
/// some hundred operations. alpha_2 is 0 where it would be negative, which is where h_b <= d; likewise alpha_3, where
/// h' is far above h.
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

/// alpha_I1, which depends on the shape of the mound alone. It is largest, 1, at B_M/L = 0.12 and (h - d)/h = 0.6, and
/// below 0 on low mounds (delta_22 < -0.3206), where no impulsive pressure is expected.
double alpha_I1(double berm_width_over_wavelength, double mound_height_over_depth);

/// alpha_I0 = min(H/d, 2).
double alpha_I0(double height, double berm_depth);

struct Stability {
  double safety_sliding = 0.;           ///< mu (W' - U) / P
  double safety_overturning = 0.;       ///< (W' t - M_U) / M_P
  std::optional<double> heel_pressure;  ///< p_e, under the heel (Pa); none where it overturns or floats
  double sliding_force = 0.;            ///< F_Smax = P + mu U (N/m)
  double resistance = 0.;               ///< mu W', less the push of still water at two levels (N/m)
  double ratio = 0.;                    ///< r = F_Smax over that; not 1/S.F. unless U = 0
  double force = 0., moment = 0.;       ///< P (N/m) and M_P (N m/m), which act, with that push
};

/// Under the wave and under `still`, whose push counts where it acts with the wave and is left out, on the safe side,
/// where it acts against it.
Stability stability(const Section& section, const WavePressure& pressure, const StillWater& still = {});

/// Submerged weight W' (N/m) for which the safety factor against sliding is `safety_sliding`.
double submerged_weight_for(double safety_sliding, double friction, const WavePressure& pressure);

/// All warnings for a wave on a section.
NumberedWarnings warnings(const Section& section, const Water& water, const DesignWave& wave,
                          const WavePressure& pressure);

/// tau_0F = (1/2 - H/(8 h)) T (s), eq. (11), stated for 0 <= H/h <= 0.8; beyond H/h = 0.8 it keeps its last value 0.4 T
/// (our extension, which makes tau_0F continuous).
double standing_duration(double height, double depth, double period);

/// k(alpha*) of eqs. (8)-(9): tau_0 = k tau_0F. Committees calibrate a and b.
struct DurationFactor {
  double a = 0.3, b = 2.;
  /// k = 1 / (alpha*^a + 1)^b; a negative alpha* counts as 0.
  double operator()(double alpha_star) const;
};

}  // namespace upbead
