// The family of slip circles of a reduced scene, with the readings that each wave's factors need.
#pragma once

#include <optional>
#include <string>

#include "upbead/dynamics/reduce.h"
#include "upbead/run/simulation.h"
#include "upbead/rupture/circle_family.h"

namespace upbead {

struct CircleModelMade {
  std::optional<CircleModel> model;
  std::string why_not;  ///< "" where there is one
  double seconds = 0.;
};

/// A circle for each of some thirty effective widths of the base, from all of it down to nearly nothing, landward, and
/// for half as many seaward: the least one under the scene's own wave, scaled so that its load stands on
/// that width, by the pore pressure computed and by that of still water. Its gap is found by full searches under that
/// wave scaled. `reduction`: of the scene bonded, with pressures kept.
CircleModelMade circle_model(const Simulation& simulation, const Reduction& reduction);

/// The readings of a family (circle_family.h) as those of a reduced scene.
ModalModel circle_readings(const CircleFamily& family, const Simulation& simulation, const PressureModel& pressures);

}  // namespace upbead
