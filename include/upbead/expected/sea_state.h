// Sea states, and the heights of their waves.
#pragma once

#include <limits>

namespace upbead {

/// Waves of one significant height.
struct SeaState {
  double significant_height = 0.;  ///< H_1/3 at the wall (m)
  double period = 0.;              ///< T, the significant one (s)
  double waves = 0.;               ///< their number
  double angle = 0.;               ///< beta, already turned towards the wall's normal (rad)
  double water_level = 0.;         ///< still water above that of the section (m)
};

/// Heights after Rayleigh (Longuet-Higgins 1952): exp(-2 (H / H_1/3)^2) of all waves are higher than H. Waves beyond a
/// cut are set aside: they count as waves that do not slide, and the others are not made more by as many.
class RayleighHeights {
 public:
  static constexpr double no_cut = std::numeric_limits<double>::infinity();

  /// `cut`: over H_1/3. Throws std::invalid_argument where one is not above 0.
  explicit RayleighHeights(double significant_height, double cut = no_cut);
  /// Share of all waves that are higher than H and not beyond the cut.
  double exceedance(double height) const;
  /// Density of H (1/m).
  double density(double height) const;
  /// H that such a share of all waves exceeds; of the largest share the least height 0, of no share the cut.
  double height(double exceedance) const;
  double significant_height() const { return significant_height_; }
  /// The highest wave (m); infinity without a cut.
  double highest() const { return highest_; }

 private:
  double significant_height_, highest_, beyond_;
};

}  // namespace upbead
