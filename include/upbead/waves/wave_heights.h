// Lengths of small-amplitude waves, and design heights of random waves near the shore, after Goda (2000).
#pragma once

namespace upbead {

/// kh with k = 2 pi / L, from omega^2 h / g = kh tanh(kh), to round-off at any depth.
/// `depth` h in m, `period` T in s, both above 0.
double relative_wave_number(double period, double depth, double gravity);

/// L at that depth (m).
double wavelength(double period, double depth, double gravity);

/// L_0 = g T^2 / (2 pi) (m).
double deep_water_wavelength(double period, double gravity);

/// A sea state in deep water and the place that it runs to.
struct Approach {
  double deep_water_height = 0.;  ///< H_0', equivalent deep-water significant height (m)
  double period = 0.;             ///< T_1/3 (s)
  double depth = 0.;              ///< h where the heights are asked for (m)
  double bed_slope = 0.;          ///< tan(theta)
};

/// K_s of small waves times the correction for finite height, K_s + 0.0015 (h/L_0)^-2.87 (H_0'/L_0)^1.27.
double shoaling(const Approach& approach, double gravity);

struct DesignHeights {
  double significant = 0.;  ///< H_1/3 (m)
  double highest = 0.;      ///< H_max (m)
};

/// Both at the depth of `approach`, with the highest of random breakers h_b deep, 5 H_1/3 seaward.
DesignHeights design_heights(const Approach& approach, double gravity);

}  // namespace upbead
