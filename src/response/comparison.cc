#include "response/comparison.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace upbead {

namespace {

/// Correlation of a with b shifted to the left, over the samples that both share.
double correlation(const std::vector<double>& a, const std::vector<double>& b, std::ptrdiff_t shift) {
  double ab = 0., aa = 0., bb = 0.;
  const auto n = static_cast<std::ptrdiff_t>(a.size());
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -shift); i < std::min(n, n - shift); ++i) {
    const double x = a[static_cast<std::size_t>(i)], y = b[static_cast<std::size_t>(i + shift)];
    ab += x * y;
    aa += x * x;
    bb += y * y;
  }
  return aa > 0. && bb > 0. ? ab / std::sqrt(aa * bb) : 0.;
}

/// The shift with the best correlation, up to a quarter of the length, refined between samples by a parabola.
double best_shift(const std::vector<double>& a, const std::vector<double>& b) {
  const auto most = static_cast<std::ptrdiff_t>(a.size() / 4);
  std::ptrdiff_t best = 0;
  double largest = correlation(a, b, 0);
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift)
    if (const double now = correlation(a, b, shift); now > largest) {
      largest = now;
      best = shift;
    }
  const double before = correlation(a, b, best - 1), after = correlation(a, b, best + 1),
               bend = before - 2. * largest + after;
  return static_cast<double>(best) + (bend < 0. ? 0.5 * (before - after) / bend : 0.);
}

}  // namespace

Comparison compare(const History& measured, const History& computed) {
  const double begin = std::max(measured.time.front(), computed.time.front()),
               end = std::min(measured.time.back(), computed.time.back());
  constexpr int n = 2000;
  if (!(end > begin)) throw std::invalid_argument("the record and the run have no time in common");
  std::vector<double> a, b;
  for (int i = 0; i <= n; ++i) {
    const double t = begin + (end - begin) * i / n;
    a.push_back(value_at(measured.time, measured.value, t));
    b.push_back(value_at(computed.time, computed.value, t));
  }
  Comparison c;
  const auto smaller = [](double x, double y) { return std::abs(x) < std::abs(y); };
  for (std::size_t i = 0; i < measured.time.size(); ++i)  // also at the samples, whose peak may lie between equal steps
    if (measured.time[i] >= begin && measured.time[i] <= end)
      c.peak_measured = std::max(c.peak_measured, measured.value[i], smaller);
  if (c.peak_measured == 0.) throw std::invalid_argument("the record is zero throughout");
  const double sign = c.peak_measured < 0. ? -1. : 1.;
  c.peak_computed = sign * value_at(computed.time, computed.value, begin);
  for (std::size_t i = 0; i < computed.value.size(); ++i)
    if (computed.time[i] >= begin && computed.time[i] <= end)
      c.peak_computed = std::max(c.peak_computed, sign * computed.value[i]);
  c.peak_computed *= sign;
  c.peak_ratio = c.peak_computed / c.peak_measured;
  double difference = 0., size = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += (b[i] - a[i]) * (b[i] - a[i]);
    size += a[i] * a[i];
  }
  c.rms = std::sqrt(difference / static_cast<double>(a.size()));
  c.rms_relative = std::sqrt(difference / size);
  c.phase = best_shift(a, b) * (end - begin) / n;
  return c;
}

}  // namespace upbead
