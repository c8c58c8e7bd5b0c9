// Answers on ever finer cells against an exact one that they may not fall below.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "record.h"

namespace upbead::test {

/// Unknowns and relative error. Checks that all are above, that each error is at most 0.75 times that before, and the
/// last one at most `limit`; all are written down.
void tends_from_above(Record& record, const std::string& what, const std::vector<std::pair<int, double>>& errors,
                      double limit);

}  // namespace upbead::test
