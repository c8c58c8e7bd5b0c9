// Soil of a mesh that yields: a law of stress at every point of quadrature, and the internal force of these stresses.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fem/probes.h"
#include "fem/unknowns.h"
#include "material/soil.h"
#include "system/internal_force.h"

namespace upbead {

/// Makes the soil at a point of quadrature of an active cell; null for cells that stay elastic, which are skipped.
using PointsOfCells = std::function<std::unique_ptr<SoilPoint>(unsigned cell, unsigned point)>;

/// Stress at a point of quadrature, at the last commit.
struct BorneStress {
  dealii::Point<dim> at;
  PlaneStress change;     ///< of effective stress since rest (Pa)
  double mobilised = 0.;  ///< share of the strength, see SoilAt
};

/// Soil that yields also reports its stresses and losses.
class YieldingSoil : public InternalForce {
 public:
  /// Stresses at the points of each active cell; empty for cells that stay elastic.
  virtual std::vector<std::vector<BorneStress>> borne() = 0;
  /// Energy dissipated so far by active cell index (J/m); -1 for cells that stay elastic.
  virtual const std::vector<double>& dissipated() const = 0;
  /// Share of all updates of a cell's stresses that were skipped, as none of the cell's soil could have yielded.
  virtual double share_skipped() const = 0;
};

/// How laws are evaluated; the options change the result by round-off at most.
struct SoilWork {
  bool by_points = false;  ///< each point by itself, without lanes: the reference
  int threads = 0;         ///< see Crew; the result is bitwise the same with any number
  /// Skips cells whose strain has changed since the last commit by less than any of their soil needs to yield: their
  /// part of p is bitwise what it was.
  bool skip = true;
  int n_unknowns = 0;  ///< of the system, where it lacks the last ones of `unknowns`, those of an interface; 0: all
  /// The system, where it is divided, and the cells of this process: each evaluates the laws of its own, and the forces
  /// of all are summed. What the soil then tells is that of the whole, but for the energies and readings, which are
  /// parts; all processes make the same calls.
  const System* divided = nullptr;
  std::vector<bool> own_cells{};
  std::vector<FollowedReading> followed{};  ///< readings that take the law's stress
};

/// p = integral of B^T (D eps - sigma) over the cells that yield, with sigma the law's stress for the strain since
/// rest, and D the elastic law of the cell, whose stiffness is in K. `readings`: those of the system, see
/// Reading::nodal_forces; `space` and `unknowns` outlive it.
std::unique_ptr<YieldingSoil> yielding_soil(const Space& space, const Unknowns& unknowns,
                                            const std::vector<Reading>& readings, const PointsOfCells& points,
                                            const SoilWork& work = {});

}  // namespace upbead
