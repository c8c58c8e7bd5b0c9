// What the sliding distances of many lives tell.
#pragma once

#include <array>
#include <vector>

namespace upbead {

using Interval = std::array<double, 2>;

struct Quantile {
  double probability = 0.;
  double value = 0.;
};

/// P(S > limit), and where it lies with 95 % confidence, by Clopper and Pearson (1934).
struct Exceeded {
  double limit = 0.;
  double probability = 0.;
  Interval interval{};
};

struct LifeStatistics {
  double mean = 0.;
  double standard_error = 0.;  ///< of the mean
  Interval interval{};         ///< of the mean, 95 %, Student's t: too narrow where few lives bring most of the sum
  std::vector<Quantile> quantiles;
  std::vector<Exceeded> exceeded;
  int sliding_lives = 0;  ///< lives with S > 0
};

/// `sliding`: S of each life (m), at least two. Sums are taken in the order given, so that they do not depend on who
/// computed them. Quantiles: the least S that such a share of the lives does not exceed.
LifeStatistics statistics(const std::vector<double>& sliding, const std::vector<double>& limits = {0.1, 0.3, 1.});

}  // namespace upbead
