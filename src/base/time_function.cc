#include "upbead/base/time_function.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace upbead {

TimeFunction::TimeFunction() : pieces_{[](double) { return 0.; }} {}

TimeFunction::TimeFunction(std::vector<double> kinks, std::vector<Piece> pieces)
    : kinks_(std::move(kinks)), pieces_(std::move(pieces)) {
  if (pieces_.size() != kinks_.size() + 1 || !std::is_sorted(kinks_.begin(), kinks_.end()))
    throw std::logic_error("TimeFunction: kinks must ascend, with one piece more than kinks");
}

std::size_t TimeFunction::piece_at(double t) const {
  return static_cast<std::size_t>(std::upper_bound(kinks_.begin(), kinks_.end(), t) - kinks_.begin());
}

double TimeFunction::operator()(double t) const {
  return pieces_[piece_at(t)](t);
}

double TimeFunction::operator()(double t, double inside) const {
  return pieces_[piece_at(inside)](t);
}

namespace {

/// Indices of the samples between which the record is smooth: the ends, and where the slope changes markedly.
std::vector<std::size_t> corners(const std::vector<double>& time, const std::vector<double>& value) {
  const std::size_t n = time.size();
  const auto slope = [&](std::size_t i) { return (value[i + 1] - value[i]) / (time[i + 1] - time[i]); };
  double largest = 0.;
  for (std::size_t i = 0; i + 1 < n; ++i) largest = std::max(largest, std::abs(slope(i)));
  std::vector<std::size_t> list{0};
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (std::abs(slope(i) - slope(i - 1)) > 0.05 * largest) list.push_back(i);
  list.push_back(n - 1);
  return list;
}

}  // namespace

TimeFunction piecewise_linear(const std::vector<double>& time, const std::vector<double>& value) {
  const std::vector<std::size_t> corner = corners(time, value);
  std::vector<double> kinks;
  std::vector<TimeFunction::Piece> pieces{[](double) { return 0.; }};
  for (std::size_t c = 0; c + 1 < corner.size(); ++c) {
    const auto first = static_cast<std::ptrdiff_t>(corner[c]), last = static_cast<std::ptrdiff_t>(corner[c + 1]) + 1;
    std::vector<double> t(time.begin() + first, time.begin() + last);
    std::vector<double> y(value.begin() + first, value.begin() + last);
    kinks.push_back(t.front());
    pieces.push_back([t = std::move(t), y = std::move(y)](double at) {
      const auto above = std::upper_bound(t.begin() + 1, t.end() - 1, at) - t.begin();
      const auto i = static_cast<std::size_t>(above);
      return y[i - 1] + (y[i] - y[i - 1]) * (at - t[i - 1]) / (t[i] - t[i - 1]);
    });
  }
  kinks.push_back(time.back());
  pieces.push_back([](double) { return 0.; });
  return TimeFunction(std::move(kinks), std::move(pieces));
}

TimeFunction sum(const TimeFunction& a, const TimeFunction& b) {
  std::vector<double> kinks;
  std::set_union(a.kinks().begin(), a.kinks().end(), b.kinks().begin(), b.kinks().end(), std::back_inserter(kinks));
  kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
  std::vector<TimeFunction::Piece> pieces;
  for (std::size_t i = 0; i <= kinks.size(); ++i) {
    const double inside = kinks.empty()       ? 0.
                          : i == 0            ? kinks.front() - 1.
                          : i == kinks.size() ? kinks.back() + 1.
                                              : 0.5 * (kinks[i - 1] + kinks[i]);
    pieces.push_back([a, b, inside](double t) { return a(t, inside) + b(t, inside); });
  }
  return TimeFunction(std::move(kinks), std::move(pieces));
}

TimeFunction scaled(const TimeFunction& f, double scale) {
  std::vector<TimeFunction::Piece> pieces;
  const std::vector<double>& kinks = f.kinks();
  for (std::size_t i = 0; i <= kinks.size(); ++i) {
    const double inside = kinks.empty() ? 0. : i == 0 ? kinks.front() - 1. : kinks[i - 1];
    pieces.push_back([f, scale, inside](double t) { return scale * f(t, inside); });
  }
  return TimeFunction(kinks, std::move(pieces));
}

namespace {
/// The smooth pieces of f within [t0, t1], as pairs of times.
std::vector<std::pair<double, double>> smooth_pieces(const TimeFunction& f, double t0, double t1) {
  std::vector<double> ends{t0};
  for (double kink : f.kinks())
    if (kink > t0 && kink < t1 && kink > ends.back()) ends.push_back(kink);
  ends.push_back(t1);
  std::vector<std::pair<double, double>> list;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) list.emplace_back(ends[i], ends[i + 1]);
  return list;
}
}  // namespace

double integral(const TimeFunction& f, double t0, double t1) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  double total = 0.;
  for (const auto& [begin, end] : smooth_pieces(f, t0, t1)) {
    const double inside = 0.5 * (begin + end);
    total += Rule::integrate([&](double t) { return f(t, inside); }, begin, end, 10, 1e-9);
  }
  return total;
}

Extremum extremum(const TimeFunction& f, double t0, double t1, int sign, int samples) {
  Extremum best{t0, f(t0)};
  const auto consider = [&](double t, double value) {
    if (sign * (value - best.value) > 0.) best = {t, value};
  };
  for (const auto& [begin, end] : smooth_pieces(f, t0, t1)) {
    const double inside = 0.5 * (begin + end), step = (end - begin) / samples;
    int top = 0;
    const auto value = [&](int i) { return f(begin + i * step, inside); };
    for (int i = 0; i <= samples; ++i) {
      if (sign * (value(i) - value(top)) > 0.) top = i;
      consider(begin + i * step, value(i));
    }
    const double low = begin + std::max(0, top - 1) * step, high = begin + std::min(samples, top + 1) * step;
    const auto [at, lowest] =
        boost::math::tools::brent_find_minima([&](double t) { return -sign * f(t, inside); }, low, high, 40);
    consider(at, -sign * lowest);
  }
  return best;
}

}  // namespace upbead
