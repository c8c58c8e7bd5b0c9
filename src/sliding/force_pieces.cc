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

/// The history between two times that no point of it separates; `before` and `after` hold beyond its points.
Line line_between(const ForceHistory& history, double start, double stop, double before, double after) {
  const auto next = std::upper_bound(history.time.begin(), history.time.end(), start) - history.time.begin();
  const auto i = static_cast<std::size_t>(next);
  if (i == 0) return {before, before};
  if (i == history.time.size()) return {after, after};
  const double begin = history.time[i - 1], length = history.time[i] - begin;
  const Line whole{history.value[i - 1], history.value[i]};
  return {whole.at((start - begin) / length), whole.at((stop - begin) / length)};
}

}  // namespace

ForcePiece ForcePiece::after(double passed) const {
  const double fraction = passed / length;
  return {start + passed, length - passed, {force.at(fraction), force.end}, {resistance.at(fraction), resistance.end}};
}

std::vector<ForcePiece> force_pieces(const ForceHistory& force, const ForceHistory& resistance) {
  check(force, "force");
  check(resistance, "resistance");
  if (resistance.value.empty() || *std::min_element(resistance.value.begin(), resistance.value.end()) < 0.)
    throw std::invalid_argument("resistance: at least one value, none below zero");
  std::vector<double> times(force.time);
  times.insert(times.end(), resistance.time.begin(), resistance.time.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<ForcePiece> pieces;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double start = times[i], stop = times[i + 1];
    pieces.push_back({start, stop - start, line_between(force, start, stop, 0., 0.),
                      line_between(resistance, start, stop, resistance.value.front(), resistance.value.back())});
  }
  return pieces;
}

}  // namespace upbead::detail
