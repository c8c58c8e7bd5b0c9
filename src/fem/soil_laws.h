// Soil that yields: the law of each cell, and its stress at rest.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fem/rest_state.h"
#include "fem/static_stage.h"
#include "fem/yielding_soil.h"
#include "material/soil_law.h"

namespace upbead {

/// Areas where laws cannot bear the stress at rest.
struct RestReport {
  double area = 0.;    ///< of soil that yields (m2)
  double beyond = 0.;  ///< part of it where the stress at rest exceeds the strength (m2)
};

/// Points of quadrature that compact, each with its active cell; the owner of the soil keeps the points alive.
using CompactingPoints = std::vector<std::pair<unsigned, const CompactingPoint*>>;

struct SoilLaws {
  PointsOfCells points;
  RestReport report;
  std::shared_ptr<CompactingPoints> compacting;  ///< the points made so far that compact
};

/// Laws of the cells of a scene whose static state is `rest`. Laws that need a balanced stress at rest start from those
/// of the rest_state, `failing`. Where that is null they start from the stress of the elastic ground, with s'_x = K_0
/// s'_y where K_0 is given; no law then follows the stress in excess of the strength.
SoilLaws soil_laws(const Scene& scene, const Space& space, const EffectiveStress& rest, RestStart start,
                   const PointStresses* failing = nullptr);

}  // namespace upbead
