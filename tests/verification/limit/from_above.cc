#include "from_above.h"

#include <algorithm>

namespace upbead::test {

void tends_from_above(Record& record, const std::string& what, const std::vector<std::pair<int, double>>& errors,
                      double limit) {
  double least = errors.front().second, slowest = 0.;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto& [unknowns, error] = errors[i];
    const std::string told = what + ": error, " + std::to_string(unknowns) + " unknowns";
    if (i + 1 < errors.size())
      record.measured(told, error);
    else
      record.at_most(told, error, limit);
    least = std::min(least, error);
    if (i > 0) slowest = std::max(slowest, error / errors[i - 1].second);
  }
  record.at_least(what + ": least of these errors, from above", least, 0.);
  record.at_most(what + ": largest error over that on the coarser cells", slowest, 0.75);
}

}  // namespace upbead::test
