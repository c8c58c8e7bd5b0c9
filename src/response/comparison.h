// The difference between a computed and a measured history.
#pragma once

#include "upbead/base/history.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Throws std::invalid_argument where the histories share fewer than two times, or the measured one is zero there.
Comparison compare(const History& measured, const History& computed);

}  // namespace upbead
