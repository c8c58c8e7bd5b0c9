// The motion of a boundary in time: velocities from given displacements, velocities or accelerations.
#pragma once

#include <optional>
#include <vector>

#include "upbead/model/load.h"

namespace upbead {

/// Whether a displacement that follows this pulse jumps, so that it has no velocity.
bool jumps(const Pulse& pulse);

/// Velocity (m/s) of a motion that follows a pulse, from rest at t = 0; a displacement must not jump.
TimeFunction velocity(LoadKind kind, const Pulse& pulse);
/// Load::duration of such a motion.
std::optional<double> motion_duration(LoadKind kind, const Pulse& pulse);

/// Velocity of a sampled displacement: the derivative of the monotone cubic (PCHIP; Fritsch and Carlson, SIAM J.
/// Numer. Anal. 17 (1980) 238) through the samples; the boundary stands at the first value before. Zero before and
/// after the samples, of which at least four are needed.
TimeFunction rate_of_samples(const std::vector<double>& time, const std::vector<double>& value);

/// Velocity from an acceleration that is linear between samples: exact, and smooth except at both ends. Constant
/// after the last sample.
TimeFunction integral_of_samples(const std::vector<double>& time, const std::vector<double>& value);

}  // namespace upbead
