// A family of slip circles whose slices stay where they are, so that the pore pressures that each needs are linear
// readings of a reduced model: Bishop's factor of any wave at any moment without a mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// What never changes of a slice: where it is, its strength, what it weighs.
struct FamilySlice {
  double x = 0., width = 0.;            ///< of its middle (m), along x (m)
  double sine = 0., cosine = 1.;        ///< of alpha, positive where its base descends the way it slips
  double cohesion = 0., friction = 0.;  ///< c' (Pa), tan phi'
  double weight = 0.;                   ///< of the soil above, submerged, and of a surcharge (Pa)
};

struct FamilyCircle {
  double x = 0., y = 0., radius = 0.;  ///< centre, m
  double from = 0., to = 0.;           ///< x of its ends (m)
  bool landward = true;                ///< slips to larger x
  double weight_moment = 0.;           ///< of the weights about the centre, positive as it slips (N m/m)
  std::vector<FamilySlice> slices;

  /// A net pressure for each slice, then the moment of pressures on the surface.
  std::size_t n_readings() const { return slices.size() + 1; }
};

/// What the base of the caisson puts on the ground at one moment, positive landward.
struct BaseLoad {
  double force = 0., shear = 0., moment = 0.;  ///< N', F_T (N/m), M' (N m/m)
};

/// Readings by circle, in the order of `circles`: for each slice the excess pore pressure on the surface above it minus
/// that at its base (Pa), then the moment of the pressures on the surface about the centre, positive as it slips
/// (N m/m).
struct CircleFamily {
  std::vector<FamilyCircle> circles;
  double left = 0., right = 0., level = 0.;  ///< of the base (m)

  std::size_t n_readings() const;
};

/// A family, and the modes by which its readings answer a wave.
struct CircleModel {
  CircleFamily family;
  ModalModel pressures;  ///< the readings of the family, in its order
  double gap = 0.;       ///< largest by which the family's least F exceeded that of a full search, where compared
};

struct FamilyFactor {
  double factor = 0.;      ///< F
  std::size_t circle = 0;  ///< index in the family
};

/// F of one circle with the load of the base on its effective width, as circle_safety() has it, each slice bearing its
/// share of that width. `readings`: those of this circle; null stands for the pressure of still water. None where the
/// circle would leave a part of the width, nothing drives it, or it is too steep.
std::optional<double> factor_of(const CircleFamily& family, std::size_t circle, const BaseLoad& load,
                                const double* readings);

/// The circle with the least F. `readings`: of the whole family, or null. A factor of 0 where the resultant leaves the
/// base: no width bears it. None where no circle has a factor.
std::optional<FamilyFactor> least_factor(const CircleFamily& family, const BaseLoad& load, const double* readings);

/// Moments at which circles may be least safe, ascending, each once: of the largest F_T both ways, |M'/N'| and F_T/N',
/// and of the least N', while the resultant stands on a base of that width (m).
std::vector<std::size_t> moments_that_may_govern(const std::vector<double>& force, const std::vector<double>& moment,
                                                 const std::vector<double>& shear, double width);

/// The least factor over a wave.
struct CircleOfWave {
  double factor = 0.;      ///< 0 where the resultant leaves the base
  std::size_t moment = 0;  ///< index of the time
  std::size_t circle = 0;  ///< index in the family
  bool computed = false;   ///< by the pressure computed; else by that of still water
};

/// The least factor at the first moment, at rest, and at those that may govern: by the pore pressure of still water,
/// and by that computed, `readings`(moments) with a column for each moment. F_T, N' and M' over time. None where no
/// circle has a factor.
std::optional<CircleOfWave> circle_of_wave(
    const CircleFamily& family, const std::vector<double>& force, const std::vector<double>& moment,
    const std::vector<double>& shear,
    const std::function<Eigen::MatrixXd(const std::vector<std::size_t>& moments)>& readings);

/// The first moment at which the resultant does not stand on the base; none where it always does.
std::optional<std::size_t> first_without_stand(const std::vector<double>& force, const std::vector<double>& moment,
                                               double width);

}  // namespace upbead
