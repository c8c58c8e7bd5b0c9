// One reduced model for all soils of a box, and all waves: a scene whose System is a sum over its soils' constants.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "dynamics/reduced_family.h"
#include "fem/affine_scene.h"
#include "response/slip_reduction.h"

namespace upbead {

/// Tolerance of a member's own reduction, over that of the family.
constexpr double share_of_member = 0.2;

/// What a member of the family is: coefficients by part of AffineScene.
using Factors = std::vector<double>;

/// A scene in one basis for all its soils.
struct SoilFamily {
  ReducedFamily reduced;
  FieldBasis phi;      ///< of the family's coordinates
  CompiledScene like;  ///< of the bonded scene that was reduced; its system has no matrices
  /// Where the family is that of a caisson that slips as a whole: its system, without matrices.
  std::optional<System> slipping;

  /// The bonded scene with that soil as a small dense System, whose unknowns are coordinates of the basis; `share`: of
  /// the basis that is used, see leading().
  CompiledScene at(const Factors& factors, double share = 1.) const;
  /// The same of a caisson that slips, see slip_system(). To be called where `slipping` is there.
  SlipSystem slips_at(const Factors& factors) const;
};

/// What is left of a System where a small one stands for it.
System without_matrices(System system);

struct SoilFamilyOptions {
  std::vector<Factors> candidates;       ///< soils of the box: the first is the first point, one of the others the next
  double tolerance = 2e-3;               ///< of the histories of held_readings() over their peaks, for each candidate
  std::optional<double> of_estimates{};  ///< what candidates' estimates may be; the tolerance where there is none
  int most_points = 8;
  std::function<void(double)> progress{};  ///< 0 to 1; may be empty
};

/// How a family was made.
struct SoilFamilyMade {
  SoilFamily family;
  std::vector<int> points;        ///< candidates that were solved
  std::vector<double> estimates;  ///< largest estimate over the candidates, after each point
};

/// Solves soils, two side by side, each time that with the largest estimate (a greedy choice: Veroy, Prud'homme, Rovas
/// and Patera 2003) and that which is least like all points, until all candidates meet `of_estimates` by their
/// estimates and the last two the tolerance by their errors before they became points, or `most_points` are solved.
/// From these errors follows the factor of the estimates. `affine` is of the bonded scene or, see with_slip(), of a
/// caisson that slips; `like`: the bonded scene, compiled. Throws NumericsError as snapshots() does.
SoilFamilyMade make_soil_family(const Scene& scene, const AffineScene& affine, const CompiledScene& like,
                                const SoilFamilyOptions& options);

/// The parts of a scene with an interface, for a caisson that slips as a whole: its systems are those of slip_system(),
/// its body_coordinates the unknowns that are kept exactly.
AffineScene with_slip(const AffineScene& affine);

/// Largest difference of a history of held_readings() between nested members over its peak, times the family's safety,
/// under the scene's own loads.
double family_error(const SoilFamily& family, const Scene& scene, const Factors& factors);
/// The same of a soil that is to be answered: `member`: SoilFamily::at() with the scene's courses; the space in which
/// it is reduced is left in `room`.
double family_error(const SoilFamily& family, const Scene& scene, const Factors& factors, const CompiledScene& member,
                    BasisRoom& room);

}  // namespace upbead
