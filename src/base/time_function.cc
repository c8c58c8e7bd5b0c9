#include "upbead/base/time_function.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/numbers.h"

namespace upbead {

TimeFunction::TimeFunction() : pieces_{[](double) { return 0.; }} {}

TimeFunction::TimeFunction(std::vector<double> kinks, std::vector<Piece> pieces, std::vector<double> samples)
    : kinks_(std::move(kinks)), pieces_(std::move(pieces)), samples_(std::move(samples)) {
  if (pieces_.size() != kinks_.size() + 1 || !std::is_sorted(kinks_.begin(), kinks_.end()))
    throw std::logic_error("TimeFunction: kinks must ascend, with one piece more than kinks");
}

const TimeFunction::Piece& TimeFunction::piece(double inside) const {
  return pieces_[static_cast<std::size_t>(std::upper_bound(kinks_.begin(), kinks_.end(), inside) - kinks_.begin())];
}

double TimeFunction::operator()(double t) const {
  return piece(t)(t);
}

double TimeFunction::operator()(double t, double inside) const {
  return piece(inside)(t);
}

namespace {

constexpr std::size_t max_corners = 50;  // a drawn record has a few corners; a measured one has them nearly everywhere

/// Straight lines between samples. Shared, because the pieces of sums and multiples all need the whole record.
struct Record {
  std::vector<double> time, value;

  /// At a time within the samples from `first` to `last`, between which there is no jump.
  double at(double when, std::size_t first, std::size_t last) const {
    if (when >= time[last]) return value[last];
    const auto begin = time.begin() + static_cast<std::ptrdiff_t>(first),
               end = begin + static_cast<std::ptrdiff_t>(last - first);
    const auto i = static_cast<std::size_t>(std::upper_bound(begin + 1, end, when) - time.begin());
    return value[i - 1] + (value[i] - value[i - 1]) * (when - time[i - 1]) / (time[i] - time[i - 1]);
  }
  bool jumps(std::size_t i) const { return time[i + 1] == time[i]; }
  double slope(std::size_t i) const { return (value[i + 1] - value[i]) / (time[i + 1] - time[i]); }
};

/// Samples between which the record is smooth: corners, and both samples of a jump; of a record with too many corners
/// its ends and jumps alone. Two a piece: where it begins and where it ends.
std::vector<std::array<std::size_t, 2>> pieces_of(const Record& record) {
  const std::size_t n = record.time.size();
  double largest = 0.;
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (!record.jumps(i)) largest = std::max(largest, std::abs(record.slope(i)));
  const auto is_corner = [&](std::size_t i) {
    return !record.jumps(i - 1) && !record.jumps(i) && std::abs(record.slope(i) - record.slope(i - 1)) > 0.05 * largest;
  };
  std::size_t n_corners = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) n_corners += is_corner(i) ? 1 : 0;
  std::vector<std::array<std::size_t, 2>> pieces;
  std::size_t begin = 0;
  const auto end_at = [&](std::size_t end) {
    if (end > begin) pieces.push_back({begin, end});
  };
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (!record.jumps(i) && (i == 0 || n_corners > max_corners || !is_corner(i))) continue;
    end_at(i);
    begin = record.jumps(i) ? i + 1 : i;
  }
  end_at(n - 1);
  return pieces;
}

std::vector<double> united(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  both.erase(std::unique(both.begin(), both.end()), both.end());
  return both;
}

/// A time inside the i-th piece between the `kinks`.
double inside_piece(const std::vector<double>& kinks, std::size_t i) {
  if (kinks.empty()) return 0.;
  if (i == 0) return kinks.front() - 1.;
  return i == kinks.size() ? kinks.back() + 1. : 0.5 * (kinks[i - 1] + kinks[i]);
}

}  // namespace

TimeFunction piecewise_linear(const std::vector<double>& time, const std::vector<double>& value) {
  const auto record = std::make_shared<const Record>(Record{time, value});
  const TimeFunction::Piece zero = [](double) { return 0.; };
  std::vector<double> kinks, samples;
  std::vector<TimeFunction::Piece> pieces{zero};
  for (const auto& [first, last] : pieces_of(*record)) {
    kinks.push_back(time[first]);
    // Just beyond a kink, round-off must not select the straight line of the neighbouring piece.
    pieces.push_back([record, first = first, last = last](double at) {
      return record->at(std::clamp(at, record->time[first], record->time[last]), first, last);
    });
  }
  kinks.push_back(time.back());
  pieces.push_back(zero);
  std::unique_copy(time.begin(), time.end(), std::back_inserter(samples));
  return TimeFunction(std::move(kinks), std::move(pieces), std::move(samples));
}

TimeFunction sum(const TimeFunction& a, const TimeFunction& b) {
  std::vector<double> kinks = united(a.kinks(), b.kinks());
  std::vector<TimeFunction::Piece> pieces;
  for (std::size_t i = 0; i <= kinks.size(); ++i) {
    const double inside = inside_piece(kinks, i);
    pieces.push_back([p = a.piece(inside), q = b.piece(inside)](double t) { return p(t) + q(t); });
  }
  return TimeFunction(std::move(kinks), std::move(pieces), united(a.samples(), b.samples()));
}

TimeFunction scaled(const TimeFunction& f, double scale) {
  std::vector<TimeFunction::Piece> pieces;
  for (std::size_t i = 0; i <= f.kinks().size(); ++i)
    pieces.push_back([scale, p = f.piece(inside_piece(f.kinks(), i))](double t) { return scale * p(t); });
  return TimeFunction(f.kinks(), std::move(pieces), f.samples());
}

TimeFunction repeated(const TimeFunction& f, int n, double period) {
  const std::vector<double>& own = f.kinks();
  if (own.size() < 2 || own.back() - own.front() > period)
    throw std::invalid_argument("a function that lasts longer than a period cannot be repeated");
  std::vector<double> kinks, samples;
  std::vector<TimeFunction::Piece> pieces{f.piece(inside_piece(own, 0))};
  for (int k = 0; k < n; ++k) {
    const double late = k * period;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const double low = own[i], high = i + 1 < own.size() ? own[i + 1] : infinity;
      kinks.push_back(kinks.empty() ? low + late : std::max(low + late, kinks.back()));
      // round-off of a late time must not leave the piece
      pieces.push_back([p = f.piece(inside_piece(own, i + 1)), late, low, high](double t) {
        return p(std::clamp(t - late, low, high));
      });
    }
    for (const double t : f.samples()) samples.push_back(t + late);
  }
  return TimeFunction(std::move(kinks), std::move(pieces), std::move(samples));
}

namespace {

/// t0, those of the ascending `times` that lie between t0 and t1, and t1.
std::vector<double> divided(const std::vector<double>& times, double t0, double t1) {
  std::vector<double> ends{t0};
  const auto first = std::upper_bound(times.begin(), times.end(), t0), last = std::lower_bound(first, times.end(), t1);
  std::unique_copy(first, last, std::back_inserter(ends));
  ends.push_back(t1);
  return ends;
}

/// Equal parts of [begin, end] and the samples between.
std::vector<double> points_within(const TimeFunction& f, double begin, double end, int parts) {
  std::vector<double> equal;
  for (int i = 0; i <= parts; ++i) equal.push_back(begin + i * ((end - begin) / parts));
  equal.back() = end;
  return united(equal, divided(f.samples(), begin, end));
}

}  // namespace

bool is_rough(const TimeFunction& f) {
  const std::vector<double>& time = f.samples();
  std::vector<double> slopes;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    const double middle = 0.5 * (time[i] + time[i + 1]);
    slopes.push_back((f(time[i + 1], middle) - f(time[i], middle)) / (time[i + 1] - time[i]));
  }
  double largest = 0.;
  for (const double slope : slopes) largest = std::max(largest, std::abs(slope));
  std::size_t corners = 0;
  for (std::size_t i = 1; i < slopes.size(); ++i)
    if (std::abs(slopes[i] - slopes[i - 1]) > 0.05 * largest &&
        !std::binary_search(f.kinks().begin(), f.kinks().end(), time[i]))
      ++corners;
  return corners > max_corners;
}

double integral(const TimeFunction& f, double t0, double t1) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  double total = 0.;
  const std::vector<double> ends = divided(united(f.kinks(), f.samples()), t0, t1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const TimeFunction::Piece& piece = f.piece(0.5 * (ends[i] + ends[i + 1]));
    total += Rule::integrate(piece, ends[i], ends[i + 1], 10, 1e-9);
  }
  return total;
}

Extremum extremum(const TimeFunction& f, double t0, double t1, int sign, int parts) {
  Extremum best{t0, f(t0)};
  const auto consider = [&](double t, double value) {
    if (sign * (value - best.value) > 0.) best = {t, value};
  };
  const std::vector<double> ends = divided(f.kinks(), t0, t1);
  for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
    const TimeFunction::Piece& piece = f.piece(0.5 * (ends[e] + ends[e + 1]));
    const std::vector<double> at = points_within(f, ends[e], ends[e + 1], parts);
    std::size_t top = 0;
    double largest = piece(at[0]);
    consider(at[0], largest);
    for (std::size_t i = 1; i < at.size(); ++i) {
      const double value = piece(at[i]);
      consider(at[i], value);
      if (sign * (value - largest) > 0.) {
        top = i;
        largest = value;
      }
    }
    const double low = at[top == 0 ? 0 : top - 1], high = at[std::min(at.size() - 1, top + 1)];
    const auto [time, lowest] =
        boost::math::tools::brent_find_minima([&](double t) { return -sign * piece(t); }, low, high, 40);
    consider(time, -sign * lowest);
  }
  return best;
}

}  // namespace upbead
