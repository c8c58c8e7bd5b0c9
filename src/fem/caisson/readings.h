// What is read of the caisson: forces at its bottom by two routes, its motion.
#pragma once

#include <array>
#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/caisson/reading_names.h"
#include "fem/scene_loads.h"
#include "upbead/system/system.h"

namespace upbead {

/// All readings of the caisson; `momentum` from momentum_rows, `uplift` from uplift_rows, `loads` from compile_loads.
std::vector<Reading> caisson_readings(const Caisson& caisson, const CaissonForces& forces,
                                      const std::array<Row, n_motions>& momentum,
                                      const std::array<Row, n_motions>& uplift, const SceneLoads& loads, bool inertia);

}  // namespace upbead
