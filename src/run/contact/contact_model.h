// Contact node by node of a case, for waves that are not known yet.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "dynamics/ground_model.h"
#include "upbead/run/simulation.h"

namespace upbead {

struct ContactModelMade {
  std::shared_ptr<const GroundModel> model;  ///< null where there is none
  std::string why_not;                       ///< then, where the caisson may slip and lift
  double seconds = 0.;
};

/// Of a simulation whose soil has converged, as run_contact() would solve it on a reduced ground; none without an
/// interface.
ContactModelMade contact_model(const Simulation& simulation, const std::function<void(double)>& progress);

}  // namespace upbead
