// Numbers that need no unit.
#pragma once

#include <limits>

namespace upbead {

constexpr double pi = 3.14159265358979323846;
constexpr double two_pi = 2. * pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace upbead
