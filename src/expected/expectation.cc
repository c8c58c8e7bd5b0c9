#include "upbead/expected/expectation.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "base/constants.h"

namespace upbead {

namespace {

/// Where S becomes positive between two heights, from below. A law's own threshold may be a safe guess: its waves are
/// looked at upwards, in steps, then by halves.
double first_sliding_height(const SlidingLaw& law, double from, double to) {
  constexpr int steps = 32, halves = 30;
  double low = from, high = infinity;
  for (int i = 1; i <= steps && high == infinity; ++i) {
    const double height = from + (to - from) * i / steps;
    if (law.distance(height) > 0.)
      high = height;
    else
      low = height;
  }
  if (high == infinity) return infinity;
  for (int i = 0; i < halves; ++i) {
    const double middle = 0.5 * (low + high);
    (law.distance(middle) > 0. ? high : low) = middle;
  }
  return low;
}

/// The height that 1e-18 of the waves beyond `from` exceed, or the cut.
double top_height(const RayleighHeights& heights, double from) {
  const double log_share = std::log(1e18);
  const double significant_height = heights.significant_height();
  return std::min(heights.highest(),
                  std::sqrt(from * from + 0.5 * log_share * significant_height * significant_height));
}

}  // namespace

Expectation expected_distance(const SlidingLaw& law, const RayleighHeights& heights, double waves,
                              const QuadratureChoice& choice) {
  Expectation result;
  result.threshold = infinity;
  const double safe = law.threshold();
  if (safe == infinity || safe >= heights.highest()) return result;
  const double top = top_height(heights, safe);
  result.threshold = first_sliding_height(law, safe, top);
  if (result.threshold == infinity) return result;
  const auto integrand = [&](double height) { return law.distance(height) * heights.density(height); };
  boost::math::quadrature::gauss_kronrod<double, 31> rule;
  result.distance =
      waves * rule.integrate(integrand, result.threshold, top, choice.depth, choice.tolerance, &result.error);
  result.error *= waves;
  result.sliding_waves = waves * heights.exceedance(result.threshold);
  return result;
}

}  // namespace upbead
