#include "upbead/expected/distribution.h"

#include <Random123/philox.h>
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

/// The inverse of a distribution of Boost, cut at both ends.
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

/// Whether the cuts are so far out that hardly any probability is left between them.
bool nothing_left(const Scatter& scatter, double mean) {
  const QuantileFunction whole =
      quantile_of({scatter.kind, mean, scatter.cov, scatter.deviation, {}, {}, {}, {}}, mean);
  return (scatter.low && whole(1. - 1e-6) < *scatter.low) || (scatter.high && whole(1e-6) > *scatter.high);
}

Diagnostics diagnose_ends(const Scatter& scatter) {
  Diagnostics list;
  if (!by_moments(scatter))
    for (const auto& [key, value] : {std::pair("low", scatter.low), std::pair("high", scatter.high)})
      if (!value) list.add(at_key(key), std::string("'") + key + "' is missing", std::string("add ") + key);
  if (scatter.low && scatter.high && *scatter.low >= *scatter.high)
    list.add(at_key("low"),
             "low = " + significant(*scatter.low, 6) + " is not below high = " + significant(*scatter.high, 6),
             "give low < high");
  else if (scatter.mode && scatter.low && scatter.high &&
           (*scatter.mode < *scatter.low || *scatter.mode > *scatter.high))
    list.add(at_key("mode"), "mode = " + significant(*scatter.mode, 6) + " is not between low and high",
             "give low <= mode <= high");
  return list;
}

Diagnostics diagnose_moments(const Scatter& scatter, double mean) {
  Diagnostics list;
  if (scatter.cov && scatter.deviation)
    list.add(at_key("cov"), "both 'cov' and 'deviation' are given", "keep one of them");
  else if (!scatter.cov && !scatter.deviation)
    list.add(at_key("deviation"), "neither 'cov' nor 'deviation' is given", "add one of them");
  else if (scatter.cov && mean == 0.)
    list.add(at_key("cov"), "'cov' means nothing with a mean of 0", "give deviation instead");
  if (scatter.kind == ScatterKind::lognormal && mean <= 0.)
    list.add(at_key("mean"), "the mean of a lognormal distribution, " + significant(mean, 6) + ", is not above 0",
             "give a mean above 0, or kind = \"normal\"");
  return list;
}

}  // namespace

Diagnostics diagnose(const Scatter& scatter, double mean) {
  Diagnostics list = diagnose_ends(scatter);
  if (!by_moments(scatter)) return list;
  const double centre = scatter.mean.value_or(mean);
  list.add(diagnose_moments(scatter, centre));
  if (list.empty() && nothing_left(scatter, centre))
    list.add(at_key(scatter.low ? "low" : "high"), "less than 1e-6 of the distribution is left between its cuts",
             "move low or high towards the mean");
  return list;
}

Distribution::Distribution(const Scatter& scatter, double mean) : per_(scatter.per) {
  for (const Diagnostic& wrong : diagnose(scatter, mean)) throw std::invalid_argument(wrong.what);
  quantile_ = quantile_of(scatter, scatter.mean.value_or(mean));
}

Stream::Stream(std::uint64_t seed) : seed_(seed) {}

std::array<std::uint32_t, 4> Stream::words(const StreamPlace& place) const {
  const r123::Philox4x32::ctr_type counter{{place[0], place[1], place[2], place[3]}};
  const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
  const r123::Philox4x32::ctr_type out = r123::Philox4x32()(counter, key);
  return {out[0], out[1], out[2], out[3]};
}

double Stream::uniform(const StreamPlace& place) const {
  const std::array<std::uint32_t, 4> w = words(place);
  const std::uint64_t bits = (static_cast<std::uint64_t>(w[0]) << 20) | (w[1] >> 12);
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;  // 53 bits: exact
}

}  // namespace upbead
