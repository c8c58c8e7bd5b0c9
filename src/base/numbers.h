// Constants, bounds of quantities in SI units, and the extreme of a record.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace upbead {

/// Far beyond any quantity of a breakwater. Within these bounds products and quotients of a few numbers stay finite,
/// so that a typing error is reported at its place, and not much later as a number that is not finite.
constexpr double largest_magnitude = 1e50;
constexpr double smallest_magnitude = 1e-50;

inline bool is_too_large(double number) {
  return std::abs(number) > largest_magnitude;
}
inline bool is_too_small(double number) {
  return number != 0. && std::abs(number) < smallest_magnitude;
}

/// Why numbers are no quantities: "is not finite", "is larger than any quantity in SI units", or "".
inline std::string objection_to(const std::vector<double>& numbers) {
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
  if (!finite) return "is not finite";
  return std::any_of(numbers.begin(), numbers.end(), is_too_large) ? "is larger than any quantity in SI units" : "";
}

/// Index of the value of largest magnitude, the first of equal ones; 0 for an empty list.
inline std::size_t index_of_largest(const std::vector<double>& values) {
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end(), smaller) - values.begin());
}

constexpr double pi = 3.14159265358979323846;
constexpr double two_pi = 2. * pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace upbead
