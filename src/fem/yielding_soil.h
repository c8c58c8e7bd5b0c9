// Soil of a mesh that yields: a law of stress at every point of quadrature, and the internal force that comes of it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fem/probes.h"
#include "fem/unknowns.h"
#include "material/soil_point.h"
#include "system/internal_force.h"

namespace upbead {

/// Makes the soil of a point of quadrature of an active cell; null of cells that stay elastic, which are skipped.
using PointsOfCells = std::function<std::unique_ptr<SoilPoint>(unsigned cell, unsigned point)>;

/// What soil bears at a point of quadrature, as committed.
struct BorneStress {
  dealii::Point<dim> at;
  PlaneStress change;     ///< of effective stress since rest (Pa)
  double mobilised = 0.;  ///< share of the strength, see SoilPoint
};

/// Soil that yields also tells where.
class YieldingSoil : public InternalForce {
 public:
  /// At the points of each active cell; none of cells that stay elastic.
  virtual std::vector<std::vector<BorneStress>> borne() = 0;
  /// Lost so far by active cell index (J/m); -1 of cells that stay elastic.
  virtual const std::vector<double>& dissipated() const = 0;
  /// Of all updates of a cell's stresses so far those that were left out, as no soil of it could have yielded.
  virtual double share_skipped() const = 0;
};

/// How laws are evaluated; the answer is the same to round-off.
struct SoilWork {
  bool by_points = false;  ///< each point by its SoilPoint, without lanes: the reference
  int threads = 0;         ///< see Crew; the answer is the same to the last bit with any number
  /// Leaves out cells whose strain has changed since the last commit by less than what any of their soil needs to
  /// yield: their part of p is then what it was, to the last bit.
  bool skip = true;
  int n_unknowns = 0;  ///< of the system, where it lacks the last ones of `unknowns`, those of an interface; 0: all
  std::vector<FollowedReading> followed{};  ///< readings that tell the law's stress
};

/// p = integral of B^T (D eps - sigma) over the cells that yield, sigma their law's answer to the strain since rest and
/// D the elastic law of the cell, whose stiffness is in K. `readings`: those of the system, see Reading::nodal_forces;
/// `space` and `unknowns` outlive it.
std::unique_ptr<YieldingSoil> yielding_soil(const Space& space, const Unknowns& unknowns,
                                            const std::vector<Reading>& readings, const PointsOfCells& points,
                                            const SoilWork& work = {});

}  // namespace upbead
