// The soil of a scene that yields: which law each cell has, and what it bears at rest.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fem/rest_state.h"
#include "fem/static_stage.h"
#include "fem/yielding_soil.h"
#include "material/compacting_point.h"

namespace upbead {

/// Rest stresses that laws cannot bear, by area.
struct RestReport {
  double area = 0.;    ///< of soil that yields (m2)
  double beyond = 0.;  ///< of it where the stress at rest exceeds the strength (m2)
};

/// Points of quadrature and the active cells that they lie in; whoever had them made keeps them alive.
using CompactingPoints = std::vector<std::pair<unsigned, const CompactingPoint*>>;

struct SoilLaws {
  PointsOfCells points;
  RestReport report;
  std::shared_ptr<CompactingPoints> compacting;  ///< of the points that were made, those that pack denser
};

/// Laws of the cells of a scene whose static state is `rest`. The largest shear stress of hysteretic soil is
/// c' cos phi' + s'_m sin phi' with the mean effective stress at rest; without a table strain its curve is the
/// hyperbola that tends to it. Mohr-Coulomb soil starts from the stresses of its rest_state, `failing`; where that is
/// null, as hysteretic soil does, from the stress of the elastic ground, s'_x = K_0 s'_y where K_0 is given: what
/// exceeds the strength there is borne by nothing that is followed.
SoilLaws soil_laws(const Scene& scene, const Space& space, const EffectiveStress& rest, RestStart start,
                   const PointStresses* failing = nullptr);

}  // namespace upbead
