// What contact node by node keeps of one System, from one run to the next.
#pragma once

#include <memory>
#include <optional>

#include "dynamics/basis.h"
#include "response/time_choice.h"
#include "run/contact/contact_recorder.h"
#include "run/contact/reduced_ground.h"

namespace upbead {

/// N_i at the nodes of the interface (N/m), and the ways tried to find them.
struct RestForces {
  Vector normal_force;
  Ladder ladder;
};

/// None of it depends on how loads go in time, on friction or on W', so that many waves share it.
struct ContactRoom {
  std::optional<RestForces> rest;     ///< where the ground was not built in stages
  double rest_level = 0.;             ///< of the water then (m)
  std::shared_ptr<BasisRoom> bonded;  ///< of the bonded caisson
  std::unique_ptr<ReducedGround> ground;
  KnownPeriods periods;
};

/// What the nodes did; friction, weight and demand are those of the whole solution.
inline ContactSolution followed_by(const ContactRecorder& recorder) {
  ContactSolution out;
  out.found.solved = recorder.summary();
  out.history = recorder.history();
  return out;
}

}  // namespace upbead
