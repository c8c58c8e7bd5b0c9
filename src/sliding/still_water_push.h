// Whether the still water of sea and harbour leaves a caisson where it is.
#pragma once

#include <string>

#include "upbead/base/still_water.h"

namespace upbead {

/// Why it does not, without a wave: it pushes the caisson with no less than mu (W' + dW'), or lifts it; then no S of a
/// wave exists. "" where the caisson stays. W' (N/m) is that in water as high as the sea; `where` follows the push.
std::string moved_by_still_water(const StillWater& still, double friction, double submerged_weight,
                                 const std::string& where = "");

}  // namespace upbead
