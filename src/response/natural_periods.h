// The free vibrations that contribute to a reading, from the poles of a reduced model.
#pragma once

#include <string>
#include <vector>

#include "upbead/dynamics/modal_response.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Of all oscillating modes, damped by less than 1/sqrt(2) of critical (with more damping resonance has no peak),
/// those with a share of at least 1 % in the reading `name` under these loads, largest share first. A
/// mode's share is its largest contribution over the sum of the largest contributions of all oscillating modes, also
/// of modes that cancel each other.
std::vector<NaturalPeriod> natural_periods(const ModalModel& model, const std::string& name, const SampledLoads& loads);

}  // namespace upbead
