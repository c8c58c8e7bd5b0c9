// The cross-section of a caisson breakwater, per metre of its length, and the waves that meet it.
#pragma once

#include <optional>
#include <vector>

#include "upbead/base/objection.h"

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
  double buoyant_weight = 0.;       ///< W', in still water (N/m)
  std::optional<double> centroid;   ///< t, from the landward heel to the line of W' (m); none: B/2
  double friction = 0.6;            ///< mu
  bool dissipating_blocks = false;  ///< whether wave-dissipating blocks cover the wall
  /// Factors of p_1, of the part of p_1 beside alpha_1, and of p_u; none: 1, or what `dissipating_blocks` makes of
  /// them.
  std::optional<double> lambda_1, lambda_2, lambda_3;
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
  double significant_height = 0.;  ///< H_1/3, tells where h_b is taken (m)
  double period = 0.;              ///< T, the significant one (s)
  double angle = 0.;               ///< beta between wave and the wall's normal, already turned towards it (rad)
};

/// Everything that contradicts itself in a section: W' not below W, a centroid outside B. What is merely outside the
/// formulas' validity is told by warnings(), see validity.h.
std::vector<Objection> objections(const Section& section);

/// The section when the still water stands `rise` higher (m; negative: lower): h, h', d and h_c follow, and W' loses or
/// gains rho g B rise where the caisson's walls are under water.
Section at_water_level(const Section& section, const Water& water, double rise);

}  // namespace upbead
