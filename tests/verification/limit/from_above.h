// Results on ever finer cells against an exact value, which is a lower bound of them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "record.h"

namespace upbead::test {

/// `errors`: unknowns and relative error. Checks that no error is negative, that each is at most 0.75 times the one
/// before, and the last at most `limit`; records all.
void tends_from_above(Record& record, const std::string& what, const std::vector<std::pair<int, double>>& errors,
                      double limit);

}  // namespace upbead::test
