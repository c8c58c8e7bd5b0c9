// Lengths of small-amplitude waves, and design heights of random waves near the shore, after Goda (2000).
#pragma once

#include <limits>

namespace upbead {

/// kh with k = 2 pi / L, from omega^2 h / g = kh tanh(kh), to round-off at any depth.
/// `depth` h in m, `period` T in s, both above 0.
double relative_wave_number(double period, double depth, double gravity);

/// L at that depth (m).
double wavelength(double period, double depth, double gravity);

/// L_0 = g T^2 / (2 pi) (m).
double deep_water_wavelength(double period, double gravity);

/// A sea state in deep water, and the place to which it propagates.
struct Approach {
  double deep_water_height = 0.;  ///< H_0', equivalent deep-water significant height (m)
  double period = 0.;             ///< T_1/3 (s)
  double depth = 0.;              ///< h at that place (m)
  double bed_slope = 0.;          ///< tan(theta)
};

/// K_s of small waves times the correction for finite height, K_s + 0.0015 (h/L_0)^-2.87 (H_0'/L_0)^1.27.
double shoaling(const Approach& approach, double gravity);

struct DesignHeights {
  double significant = 0.;  ///< H_1/3 (m)
  double highest = 0.;      ///< H_max (m)
  /// beta_0* H_0' + beta_1* h_b, the highest random breaker that the depth admits (m). It is H_max unless another
  /// branch of the formula is lower. Infinity from h/L_0 = 0.2 on, where the formulas have no breaking.
  double breaker = std::numeric_limits<double>::infinity();
};

/// H_1/3 and H_max at the depth of `approach`; H_max of random breakers with the depth h_b, 5 H_1/3 seaward.
DesignHeights design_heights(const Approach& approach, double gravity);

/// The sea in deep water that becomes a given H_1/3 at a depth.
struct SeaBefore {
  double deep_water_height = 0.;  ///< H_0' (m)
  bool reaches = true;            ///< false: this is the steepest sea, and even it gives a lower H_1/3
  DesignHeights heights;          ///< of this sea, at the depth
};

/// design_heights() inverted: its H_1/3 grows with H_0'. The steepest sea has H_max = 1.8 H_0' at Miche's (1944) limit
/// in deep water, 0.142 L_0. `place`: its deep_water_height is not used.
SeaBefore sea_before(double significant_height, Approach place, double gravity);

}  // namespace upbead
