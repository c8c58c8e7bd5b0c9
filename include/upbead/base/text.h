// Numbers in sentences.
#pragma once

#include <string>

namespace upbead {

/// A number with at most that many significant digits: "0.05", "1e-05".
std::string significant(double value, int digits = 3);

}  // namespace upbead
