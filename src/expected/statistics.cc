#include "expected/statistics.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace upbead {

namespace {

constexpr double beside = 0.025;  // on either side of 95 %

Exceeded exceeded(const std::vector<double>& sorted, double limit) {
  const auto n = static_cast<double>(sorted.size());
  const auto above = static_cast<double>(sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), limit));
  using Binomial = boost::math::binomial;
  return {limit,
          above / n,
          {above > 0. ? Binomial::find_lower_bound_on_p(n, above, beside) : 0.,
           above < n ? Binomial::find_upper_bound_on_p(n, above, beside) : 1.}};
}

double quantile_of(const std::vector<double>& sorted, double probability) {
  const double rank = std::ceil(probability * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.)) - 1];
}

}  // namespace

LifeStatistics statistics(const std::vector<double>& sliding, const std::vector<double>& limits) {
  if (sliding.size() < 2) throw std::invalid_argument("statistics need at least two lives");
  const auto n = static_cast<double>(sliding.size());
  LifeStatistics out;
  out.mean = std::accumulate(sliding.begin(), sliding.end(), 0.) / n;
  double squares = 0.;
  for (const double S : sliding) squares += (S - out.mean) * (S - out.mean);
  out.standard_error = std::sqrt(squares / (n - 1.) / n);
  const double half = quantile(complement(boost::math::students_t(n - 1.), beside)) * out.standard_error;
  out.interval = {out.mean - half, out.mean + half};
  std::vector<double> sorted = sliding;
  std::sort(sorted.begin(), sorted.end());
  for (const double p : {0.05, 0.5, 0.95, 0.99}) out.quantiles.push_back({p, quantile_of(sorted, p)});
  for (const double limit : limits) out.exceeded.push_back(exceeded(sorted, limit));
  out.sliding_lives = static_cast<int>(std::lround(exceeded(sorted, 0.).probability * n));
  return out;
}

}  // namespace upbead
