// How a boundary moves in time: velocities from what people have, displacements and accelerations.
#pragma once

#include <optional>
#include <vector>

#include "upbead/model/load.h"

namespace upbead {

/// Whether a displacement by this pulse jumps, so that it has no velocity.
bool jumps(const Pulse& pulse);

/// Velocity (m/s) of a motion that runs by a pulse, from rest at t = 0; a displacement must not jump.
TimeFunction velocity(LoadKind kind, const Pulse& pulse);
/// Load::duration of such a motion.
std::optional<double> motion_duration(LoadKind kind, const Pulse& pulse);

/// Velocity of a displacement that is sampled: of the monotone cubic (PCHIP; Fritsch and Carlson, SIAM J. Numer. Anal.
/// 17 (1980) 238) through the samples, whose first value is where the boundary stands before. Zero before and after. At
/// least four samples.
TimeFunction rate_of_samples(const std::vector<double>& time, const std::vector<double>& value);

/// Velocity from an acceleration that is straight between samples: exact, smooth but at both ends. Constant from the
/// last sample on.
TimeFunction integral_of_samples(const std::vector<double>& time, const std::vector<double>& value);

}  // namespace upbead
