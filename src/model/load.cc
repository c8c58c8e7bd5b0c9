#include "upbead/model/load.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace upbead {

double intensity(const Load& load, double y) {
  const auto& shape = load.shape;
  if (shape.empty()) return 1.;
  if (y < shape.front()[0] || y > shape.back()[0]) return 0.;
  for (std::size_t i = 0; i + 1 < shape.size(); ++i) {
    const auto& [low, at_low] = shape[i];
    const auto& [high, at_high] = shape[i + 1];
    if (y <= high) return at_low + (at_high - at_low) * (y - low) / (high - low);
  }
  return shape.back()[1];
}

double sampled_duration(const std::vector<double>& time, const std::vector<double>& value, double end) {
  double peak = 0., steepest = 0.;
  for (std::size_t i = 0; i < time.size(); ++i) {
    peak = std::max(peak, std::abs(value[i]));
    if (i > 0) steepest = std::max(steepest, std::abs((value[i] - value[i - 1]) / (time[i] - time[i - 1])));
  }
  if (peak == 0.) return std::numeric_limits<double>::infinity();
  const double noise = 0.05 * peak;
  if (std::abs(value.front()) > noise || (time.back() < end && std::abs(value.back()) > noise)) return 0.;
  return 2. * peak / steepest;
}

}  // namespace upbead
