// A prescribed uplift: its pressure on the base.
#pragma once

#include <array>
#include <vector>

#include "run/sliding/uplift_course.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// p_u(x, t) of the scene's prescribed uplift on the nodes of the base at `position` (m), each for a `length` of the
/// base (m); none without a prescribed uplift or a caisson. Where it is given by a peak or history, `distribution`
/// says how it is spread, and f is U(t).
std::vector<UpliftLoad> uplift_loads(const Simulation& simulation, const std::vector<double>& position,
                                     const std::vector<double>& length);

/// The same of an uplift U(t) by its distribution, under waves that push landward or seaward; needs a prescribed
/// uplift.
UpliftLoad uplift_of_peak(const Simulation& simulation, const std::vector<double>& position,
                          const std::vector<double>& length, bool seaward, const TimeFunction& U = {});

/// p(t) of the loads on the caisson's walls at their feet, seaward and landward (Pa): that of the water there, but for
/// a sea that is meshed.
std::array<TimeFunction, 2> pressures_at_feet(const Simulation& simulation);

}  // namespace upbead
