#include "reliability/indices.h"

#include <algorithm>
#include <cmath>
#include <openturns/OT.hxx>

namespace upbead {

namespace {

constexpr std::size_t fewest_points = 8;  // with fewer an interval says nothing
constexpr double round_off = 1e-12;       // a number that varies by less, over its size, is constant

/// Outputs of all rows of A, then B, then A with each column of B, as OpenTURNS wants them.
OT::Sample output_design(const std::vector<std::vector<double>>& points) {
  const std::size_t n = points.size(), rows = points.front().size();
  OT::Sample outputs(n * rows, 1);
  for (std::size_t m = 0; m < rows; ++m)
    for (std::size_t i = 0; i < n; ++i) outputs(m * n + i, 0) = points[i][m];
  return outputs;
}

/// Mean and standard deviation of the rows of A and B, which are independent draws.
void describe_draws(const std::vector<std::vector<double>>& points, NumberIndices& found) {
  const double n = 2. * static_cast<double>(points.size());
  double sum = 0., square = 0.;
  for (const auto& point : points) sum += point[0] + point[1];
  const double mean = sum / n;
  for (const auto& point : points) square += std::pow(point[0] - mean, 2) + std::pow(point[1] - mean, 2);
  found.mean = mean;
  found.deviation = std::sqrt(square / (n - 1.));
}

bool is_constant(const std::vector<std::vector<double>>& points) {
  double low = points[0][0], high = low;
  for (const auto& point : points) {
    low = std::min(low, *std::min_element(point.begin(), point.end()));
    high = std::max(high, *std::max_element(point.begin(), point.end()));
  }
  return high - low <= round_off * std::max(std::abs(low), std::abs(high));
}

Estimate estimate(const OT::Point& value, const OT::Interval& interval, std::size_t key) {
  return {value[key], interval.getLowerBound()[key], interval.getUpperBound()[key]};
}

/// S_i = corr(y_B, y_ABi), T_i = 1 - corr(y_A, y_ABi): Martinez' form of the estimators of Saltelli et al. (2010) and
/// Jansen (1999), in which each variance is that of the rows compared. Intervals by the asymptotic distribution of the
/// correlation (Baudin et al. 2016), as if points were independent: those of Sobol's sequence err less.
std::vector<KeyIndices> indices_of(const std::vector<std::string>& keys,
                                   const std::vector<std::vector<double>>& points) {
  OT::Sample inputs(points.size() * points.front().size(), keys.size());  // only their number counts
  OT::MartinezSensitivityAlgorithm algorithm(inputs, output_design(points), points.size());
  algorithm.setUseAsymptoticDistribution(true);
  algorithm.setConfidenceLevel(0.95);
  const OT::Point first = algorithm.getFirstOrderIndices(), total = algorithm.getTotalOrderIndices();
  const OT::Interval of_first = algorithm.getFirstOrderIndicesInterval(),
                     of_total = algorithm.getTotalOrderIndicesInterval();
  std::vector<KeyIndices> found;
  for (std::size_t k = 0; k < keys.size(); ++k)
    found.push_back({keys[k], estimate(first, of_first, k), estimate(total, of_total, k)});
  std::stable_sort(found.begin(), found.end(),
                   [](const KeyIndices& a, const KeyIndices& b) { return a.total.value > b.total.value; });
  return found;
}

NumberIndices number_indices(const std::vector<std::string>& keys, const SobolOutputs& outputs) {
  NumberIndices found;
  found.case_file = outputs.case_file;
  found.number = outputs.number;
  found.points = static_cast<int>(outputs.points.size());
  found.left_out = outputs.left_out;
  found.failed = outputs.failed;
  found.lacking = outputs.lacking;
  if (!outputs.points.empty()) describe_draws(outputs.points, found);
  if (outputs.points.size() < fewest_points)
    found.why_not = std::to_string(outputs.points.size()) + " points have the number in all their runs, at least " +
                    std::to_string(fewest_points) + " are needed";
  else if (is_constant(outputs.points))
    found.why_not = "the number is the same in all runs: none of the keys moves it";
  else
    found.keys = indices_of(keys, outputs.points);
  return found;
}

}  // namespace

StudyIndices find_indices(const SobolStudy& study) {
  OT::Log::Show(OT::Log::NONE);
  StudyIndices indices{study.title, {}};
  for (const SobolOutputs& outputs : study.outputs) indices.numbers.push_back(number_indices(study.keys, outputs));
  return indices;
}

}  // namespace upbead
