// How far a computed history lies from a measured one.
#pragma once

#include "upbead/base/history.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Throws std::invalid_argument where they share fewer than two times, or the measured one is zero there.
Comparison compare(const History& measured, const History& computed);

}  // namespace upbead
