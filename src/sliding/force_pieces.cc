#include "sliding/force_pieces.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace upbead {

namespace {

void check(const History& history, const std::string& name) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (history.time.size() != history.value.size()) throw std::invalid_argument(name + ": not as many values as times");
  if (!std::all_of(history.time.begin(), history.time.end(), finite) ||
      !std::all_of(history.value.begin(), history.value.end(), finite))
    throw std::invalid_argument(name + ": a time or value that is not finite");
  if (!std::is_sorted(history.time.begin(), history.time.end()))
    throw std::invalid_argument(name + ": times must ascend");
}

/// Reads a history piece by piece; `before` and `after` are its values beyond its points.
class HistoryReader {
 public:
  HistoryReader(const History& history, double before, double after)
      : history_(history), before_(before), after_(after) {}

  /// The history between two times with no point in between; times must not go back from one call to the next.
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
  const History& history_;
  double before_, after_;
  std::size_t next_ = 0;  ///< point after `start`
};

/// `before` and `after`: values of the second history beyond its points.
std::vector<LinearPiece> pieces(const History& first, const History& second, double before, double after) {
  std::vector<double> times(first.time.size() + second.time.size());
  std::merge(first.time.begin(), first.time.end(), second.time.begin(), second.time.end(), times.begin());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  HistoryReader a(first, 0., 0.), b(second, before, after);
  std::vector<LinearPiece> list;
  list.reserve(times.size());
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double start = times[i], stop = times[i + 1];
    list.push_back({start, stop - start, a.between(start, stop), b.between(start, stop)});
  }
  return list;
}

}  // namespace

LinearPiece LinearPiece::after(double passed) const {
  const double fraction = passed / length;
  return {start + passed, length - passed, {first.at(fraction), first.end}, {second.at(fraction), second.end}};
}

std::vector<LinearPiece> linear_pieces(const History& first, const History& second) {
  check(first, "first history");
  check(second, "second history");
  return pieces(first, second, 0., 0.);
}

std::vector<LinearPiece> force_pieces(const History& force, const History& resistance) {
  check(force, "force");
  check(resistance, "resistance");
  if (resistance.value.empty() || *std::min_element(resistance.value.begin(), resistance.value.end()) < 0.)
    throw std::invalid_argument("resistance: at least one value, none below zero");
  return pieces(force, resistance, resistance.value.front(), resistance.value.back());
}

}  // namespace upbead
