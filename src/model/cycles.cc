#include <algorithm>

#include "base/text.h"
#include "upbead/model/scene.h"

namespace upbead {

Diagnostics diagnose(const Cycles& cycles) {
  Diagnostics list;
  const std::size_t parts = cycles.number.size();
  const auto as_many = [&](const std::string& key, std::size_t n) {
    if (n != parts)
      list.add(at_key(key),
               key + " has " + std::to_string(n) + (n == 1 ? " value" : " values") + ", and number has " +
                   std::to_string(parts),
               "give one value of each for every part of the storm");
  };
  if (parts == 0)
    list.add(at_key("number"), "the storm has no part", "give the number of waves of each part, such as [500, 200]");
  as_many("period", cycles.period.size());
  if (!cycles.height.empty()) as_many("height", cycles.height.size());
  if (!cycles.height.empty() && !cycles.run_height)
    list.add(at_key("run_height"), "the height of the run's wave is not known, over which those of the storm count",
             "add run_height, the height of the wave whose loads the case has (m), or leave out height");
  if (cycles.height.empty() && cycles.run_height)
    list.add(at_key("run_height"), "run_height is given without height", "add height of each part, or remove it");
  return list;
}

}  // namespace upbead
