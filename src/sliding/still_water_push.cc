#include "sliding/still_water_push.h"

#include <algorithm>

#include "base/text.h"

namespace upbead {

std::string moved_by_still_water(const StillWater& still, double friction, double submerged_weight,
                                 const std::string& where) {
  const double holds = friction * (submerged_weight + still.weight), push = std::max(still.push, 0.);
  if (holds > push) return "";
  return "still water pushes the caisson with " + significant(push / 1e3, 4) + " kN/m" + where +
         ", and mu (W' + dW') = " + significant(holds / 1e3, 4) + " kN/m is no more: it slides without a wave";
}

}  // namespace upbead
