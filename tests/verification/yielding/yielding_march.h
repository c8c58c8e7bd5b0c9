// Scenes on soil that yields, marched.
#pragma once

#include <memory>
#include <string>

#include "dynamics/yielding.h"
#include "fem/soil_laws.h"
#include "record.h"
#include "scenes.h"

namespace upbead::test {

struct YieldingMarch {
  /// The soil's laws are those of the scene at rest.
  YieldingMarch(const Scene& scene, const Mesh& mesh, double end, double step);

  Compiled compiled;
  std::unique_ptr<YieldingSoil> soil;
  Response response;

  Eigen::RowVectorXd history(const std::string& reading) const;
  const EnergyAccount& energy() const { return response.energy.back(); }
};

}  // namespace upbead::test
