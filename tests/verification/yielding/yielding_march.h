// Scenes on soil that yields, marched.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "record.h"
#include "scenes.h"

namespace upbead {

template <int>
class SoilAt;
class YieldingSoil;

namespace test {

/// As PointsOfCells of fem/yielding_soil.h.
using SoilPoints = std::function<std::unique_ptr<SoilAt<1>>(unsigned cell, unsigned point)>;

struct YieldingMarch {
  /// The soil's laws are those of the scene at rest, or `points` if they are given.
  YieldingMarch(const Scene& scene, const Mesh& mesh, double end, double step, const SoilPoints& points = {},
                double tolerance = 1e-9);

  Compiled compiled;
  std::shared_ptr<YieldingSoil> soil;
  Response response;

  Eigen::RowVectorXd history(const std::string& reading) const;
  const EnergyAccount& energy() const { return response.energy.back(); }
  /// Largest difference of both routes to F_T, over the largest |F_T|.
  double routes() const;
};

/// Every soil of a breakwater gets a law and a strength (degrees, Pa); still water at 15 m.
void give_law(Scene& breakwater, SoilLaw law, double friction_angle, double cohesion);

}  // namespace test
}  // namespace upbead
