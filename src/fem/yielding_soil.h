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

/// Makes the soil of a point of an active cell; null of cells that stay elastic, which are skipped.
using PointsOfCells = std::function<std::unique_ptr<SoilPoint>(unsigned cell)>;

/// What soil bears at a point of quadrature, as committed.
struct BorneStress {
  dealii::Point<dim> at;
  PlaneStress change;     ///< of effective stress since rest (Pa)
  double mobilised = 0.;  ///< share of the strength, see SoilPoint
};

/// Soil that yields also tells where.
class YieldingSoil : public InternalForce {
 public:
  /// At the points of an active cell; none of cells that stay elastic.
  virtual std::vector<BorneStress> borne(unsigned cell) const = 0;
  /// Lost so far by active cell index (J/m); -1 of cells that stay elastic.
  virtual const std::vector<double>& dissipated() const = 0;
};

/// p = integral of B^T (D eps - sigma) over the cells that yield, sigma their law's answer to the strain since rest and
/// D the elastic law of the cell, whose stiffness is in K. `readings`: those of the system, see Reading::nodal_forces;
/// of `followed` it tells the law's stress. `space` and `unknowns` outlive it.
std::unique_ptr<YieldingSoil> yielding_soil(const Space& space, const Unknowns& unknowns,
                                            const std::vector<Reading>& readings, const PointsOfCells& points,
                                            const std::vector<FollowedReading>& followed = {});

}  // namespace upbead
