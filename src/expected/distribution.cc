#include "upbead/expected/distribution.h"

#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>
#include <stdexcept>

#include "base/text.h"

namespace upbead {

namespace {

using QuantileFunction = std::function<double(double)>;

bool by_moments(const Scatter& scatter) {
  return scatter.kind == ScatterKind::normal || scatter.kind == ScatterKind::lognormal;
}

double deviation(const Scatter& scatter, double mean) {
  return scatter.deviation.value_or(scatter.cov.value_or(0.) * std::abs(mean));
}

/// The inverse of a distribution of Boost between its cuts.
template <class D>
QuantileFunction between_cuts(const D& distribution, const Scatter& scatter) {
  const double from = scatter.low ? cdf(distribution, *scatter.low) : 0.;
  const double to = scatter.high ? cdf(distribution, *scatter.high) : 1.;
  return [distribution, from, to, low = scatter.low, high = scatter.high](double u) {
    const double value = quantile(distribution, from + u * (to - from));
    return std::clamp(value, low.value_or(value), high.value_or(value));  // round-off at the cuts
  };
}

QuantileFunction quantile_of(const Scatter& scatter, double mean) {
  const double sigma = deviation(scatter, mean);
  switch (scatter.kind) {
    case ScatterKind::uniform:
      return [low = *scatter.low, high = *scatter.high](double u) { return low + u * (high - low); };
    case ScatterKind::triangular: {
      const boost::math::triangular shape(*scatter.low, *scatter.mode, *scatter.high);
      return [shape](double u) { return quantile(shape, u); };
    }
    case ScatterKind::lognormal:
      if (sigma > 0.) {
        const double variance = std::log1p(sigma / mean * (sigma / mean));  // of the logarithm
        const double location = std::log(mean) - 0.5 * variance;
        return between_cuts(boost::math::lognormal(location, std::sqrt(variance)), scatter);
      }
      break;
    case ScatterKind::normal:
      if (sigma > 0.) return between_cuts(boost::math::normal(mean, sigma), scatter);
  }
  return [mean](double) { return mean; };
}

/// Ends that are so far out that hardly anything is left between them.
bool nothing_left(const Scatter& scatter, double mean) {
  const QuantileFunction whole =
      quantile_of({scatter.kind, mean, scatter.cov, scatter.deviation, {}, {}, {}, {}}, mean);
  return (scatter.low && whole(1. - 1e-6) < *scatter.low) || (scatter.high && whole(1e-6) > *scatter.high);
}

std::vector<Objection> objections_to_ends(const Scatter& scatter) {
  std::vector<Objection> list;
  if (!by_moments(scatter))
    for (const auto& [key, value] : {std::pair("low", scatter.low), std::pair("high", scatter.high)})
      if (!value) list.push_back({key, std::string("'") + key + "' is missing", std::string("add ") + key});
  if (scatter.low && scatter.high && *scatter.low >= *scatter.high)
    list.push_back({"low",
                    "low = " + significant(*scatter.low, 6) + " is not below high = " + significant(*scatter.high, 6),
                    "give low < high"});
  else if (scatter.mode && scatter.low && scatter.high &&
           (*scatter.mode < *scatter.low || *scatter.mode > *scatter.high))
    list.push_back({"mode", "mode = " + significant(*scatter.mode, 6) + " is not between low and high",
                    "give low <= mode <= high"});
  return list;
}

std::vector<Objection> objections_to_moments(const Scatter& scatter, double mean) {
  std::vector<Objection> list;
  if (scatter.cov && scatter.deviation)
    list.push_back({"cov", "both 'cov' and 'deviation' are given", "keep one of them"});
  else if (!scatter.cov && !scatter.deviation)
    list.push_back({"deviation", "neither 'cov' nor 'deviation' is given", "add one of them"});
  else if (scatter.cov && mean == 0.)
    list.push_back({"cov", "'cov' tells nothing about a mean of 0", "give deviation instead"});
  if (scatter.kind == ScatterKind::lognormal && mean <= 0.)
    list.push_back({"mean", "the mean of a lognormal distribution, " + significant(mean, 6) + ", is not above 0",
                    "give a mean above 0, or kind = \"normal\""});
  return list;
}

}  // namespace

std::vector<Objection> objections(const Scatter& scatter, double mean) {
  std::vector<Objection> list = objections_to_ends(scatter);
  if (!by_moments(scatter)) return list;
  const double centre = scatter.mean.value_or(mean);
  for (const Objection& objection : objections_to_moments(scatter, centre)) list.push_back(objection);
  if (list.empty() && nothing_left(scatter, centre))
    list.push_back({scatter.low ? "low" : "high", "less than 1e-6 of the distribution is left between its cuts",
                    "move low or high towards the mean"});
  return list;
}

Distribution::Distribution(const Scatter& scatter, double mean) : per_(scatter.per) {
  for (const Objection& objection : objections(scatter, mean)) throw std::invalid_argument(objection.what);
  quantile_ = quantile_of(scatter, scatter.mean.value_or(mean));
}

}  // namespace upbead
