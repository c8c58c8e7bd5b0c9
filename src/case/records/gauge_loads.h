// Loads of a scene made of transducers.
#pragma once

#include "upbead/case/case.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Adds a pressure for each transducer that sees any, NAME.TRANSDUCER, spread over the wall as `share` says, in a run
/// until `end` (s).
void add_gauge_loads(const std::string& name, const GaugeLoad& by_gauges, double end, Scene& scene);

/// U(t) of transducers along a bottom between its ends (N/m); zero where it would pull. Throws InputError where it is
/// never positive.
TimeFunction uplift_of(const GaugeLoad& by_gauges);

}  // namespace upbead
