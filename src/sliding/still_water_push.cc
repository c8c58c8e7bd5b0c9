#include "sliding/still_water_push.h"

#include <cmath>

#include "base/text.h"

namespace upbead {

std::string moved_by_still_water(const StillWater& still, double friction, double submerged_weight,
                                 const std::string& where) {
  const double holds = friction * (submerged_weight + still.weight), push = std::abs(still.push);
  if (holds > push) return "";
  return std::string("still water pushes the caisson ") + (still.push < 0. ? "seaward " : "") + "with " +
         significant(push / 1e3, 4) + " kN/m" + where + ", and mu (W' + dW') = " + significant(holds / 1e3, 4) +
         " kN/m is no more: it slides without a wave";
}

}  // namespace upbead
