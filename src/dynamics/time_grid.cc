#include "upbead/dynamics/time_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace upbead {

namespace {

constexpr double tolerance = 1e-9;

/// 0, the kinks within (0, end) without near doubles, end.
std::vector<double> corners(std::vector<double> kinks, double end) {
  std::sort(kinks.begin(), kinks.end());
  std::vector<double> list{0.};
  for (double kink : kinks)
    if (kink > list.back() + tolerance * end && kink < end * (1. - tolerance)) list.push_back(kink);
  list.push_back(end);
  return list;
}

bool divides(double step, double distance) {
  const double ratio = distance / step, whole = std::round(ratio);
  return whole >= 1. && std::abs(ratio - whole) <= tolerance * ratio;
}

/// The largest step in [largest / 2, largest] that divides every distance between corners; 0 where there is none.
double common_step(const std::vector<double>& corner, double largest) {
  double shortest = corner.back();
  for (std::size_t i = 0; i + 1 < corner.size(); ++i) shortest = std::min(shortest, corner[i + 1] - corner[i]);
  const auto fits = [&](double step) {
    for (std::size_t i = 0; i + 1 < corner.size(); ++i)
      if (!divides(step, corner[i + 1] - corner[i])) return false;
    return true;
  };
  for (double n = std::ceil(shortest / largest * (1. - tolerance)); shortest / n >= largest / 2.; ++n)
    if (fits(shortest / n)) return shortest / n;
  return 0.;
}

}  // namespace

int TimeGrid::n_steps() const {
  int n = 0;
  for (const TimeSegment& segment : segments) n += segment.n_steps;
  return n;
}

int TimeGrid::n_step_sizes() const {
  std::vector<double> steps;
  for (const TimeSegment& segment : segments) steps.push_back(segment.step);
  std::sort(steps.begin(), steps.end());
  return static_cast<int>(std::unique(steps.begin(), steps.end()) - steps.begin());
}

TimeGrid make_time_grid(std::vector<double> kinks, double end, double largest_step) {
  if (!(end > 0. && largest_step > 0.)) throw std::invalid_argument("a time grid needs end > 0 and a step > 0");
  const std::vector<double> corner = corners(std::move(kinks), end);
  const double common = common_step(corner, largest_step);
  TimeGrid grid;
  grid.end = end;
  for (std::size_t i = 0; i + 1 < corner.size(); ++i) {
    const double distance = corner[i + 1] - corner[i];
    if (common > 0.) {
      grid.segments.push_back({corner[i], common, static_cast<int>(std::round(distance / common))});
      continue;
    }
    const double n = std::max(1., std::ceil(distance / largest_step * (1. - tolerance)));
    double step = distance / n;
    for (const TimeSegment& other : grid.segments)
      if (std::abs(other.step - step) <= tolerance * step) step = other.step;
    grid.segments.push_back({corner[i], step, static_cast<int>(n)});
  }
  return grid;
}

std::vector<double> kinks(const System& system) {
  std::vector<double> list;
  for (const SystemLoad& load : system.loads)
    list.insert(list.end(), load.history.kinks().begin(), load.history.kinks().end());
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace upbead
