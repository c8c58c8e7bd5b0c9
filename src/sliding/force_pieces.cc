#include "force_pieces.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace upbead::detail {

namespace {

void check(const ForceHistory& history, const std::string& name) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (history.time.size() != history.value.size()) throw std::invalid_argument(name + ": not as many values as times");
  if (!std::all_of(history.time.begin(), history.time.end(), finite) ||
      !std::all_of(history.value.begin(), history.value.end(), finite))
    throw std::invalid_argument(name + ": a time or value that is not finite");
  if (!std::is_sorted(history.time.begin(), history.time.end()))
    throw std::invalid_argument(name + ": times must ascend");
}

/// Goes through a history from piece to piece; `before` and `after` hold beyond its points.
class Walk {
 public:
  Walk(const ForceHistory& history, double before, double after) : history_(history), before_(before), after_(after) {}

  /// The history between two times that no point of it separates, not before those of the last call.
  Line between(double start, double stop) {
    const std::vector<double>& time = history_.time;
    while (next_ < time.size() && time[next_] <= start) ++next_;
    if (next_ == 0) return {before_, before_};
    if (next_ == time.size()) return {after_, after_};
    const double begin = time[next_ - 1], length = time[next_] - begin;
    const Line whole{history_.value[next_ - 1], history_.value[next_]};
    return {whole.at((start - begin) / length), whole.at((stop - begin) / length)};
  }

 private:
  const ForceHistory& history_;
  double before_, after_;
  std::size_t next_ = 0;  ///< point after `start`
};

/// All times of both, each once.
std::vector<double> merged_times(const ForceHistory& a, const ForceHistory& b) {
  std::vector<double> times(a.time.size() + b.time.size());
  std::merge(a.time.begin(), a.time.end(), b.time.begin(), b.time.end(), times.begin());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

ForcePiece ForcePiece::after(double passed) const {
  const double fraction = passed / length;
  return {start + passed, length - passed, {force.at(fraction), force.end}, {resistance.at(fraction), resistance.end}};
}

std::vector<TwoLines> two_lines(const ForceHistory& first, const ForceHistory& second) {
  check(first, "first history");
  check(second, "second history");
  const std::vector<double> times = merged_times(first, second);
  Walk a(first, 0., 0.), b(second, 0., 0.);
  std::vector<TwoLines> pieces;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double start = times[i], stop = times[i + 1];
    pieces.push_back({start, stop - start, a.between(start, stop), b.between(start, stop)});
  }
  return pieces;
}

std::vector<ForcePiece> force_pieces(const ForceHistory& force, const ForceHistory& resistance) {
  check(force, "force");
  check(resistance, "resistance");
  if (resistance.value.empty() || *std::min_element(resistance.value.begin(), resistance.value.end()) < 0.)
    throw std::invalid_argument("resistance: at least one value, none below zero");
  const std::vector<double> times = merged_times(force, resistance);
  Walk F(force, 0., 0.), R(resistance, resistance.value.front(), resistance.value.back());
  std::vector<ForcePiece> pieces;
  pieces.reserve(times.size());
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double start = times[i], stop = times[i + 1];
    pieces.push_back({start, stop - start, F.between(start, stop), R.between(start, stop)});
  }
  return pieces;
}

}  // namespace upbead::detail
