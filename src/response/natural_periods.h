// The free vibrations that a reading takes part in, by the poles of a reduced model.
#pragma once

#include <string>
#include <vector>

#include "upbead/dynamics/modal_response.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Of all modes that swing, damped by less than 1/sqrt(2) of critical (more have no peak of resonance), those with at
/// least `least_share` of the reading `name` under these loads, largest share first. A mode's share is its largest
/// contribution over the sum of those of all modes that swing: modes that cancel each other both count.
std::vector<NaturalPeriod> natural_periods(const ModalModel& model, const std::string& name, const SampledLoads& loads,
                                           double least_share = 0.01);

}  // namespace upbead
