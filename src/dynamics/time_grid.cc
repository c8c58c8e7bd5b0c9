#include "upbead/dynamics/time_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace upbead {

namespace {

constexpr double tolerance = 1e-9;
constexpr int steps_before_growth = 8;

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

/// Adds segments to a grid.
class GridBuilder {
 public:
  GridBuilder(TimeGrid& grid, double step, bool common) : grid_(grid), step_(step), common_(common) {}

  /// Equal steps from start to end, of at most `largest`.
  void add(double start, double end, double largest) {
    const double n = std::max(1., std::ceil((end - start) / largest * (1. - tolerance)));
    double step = (end - start) / n;
    for (const TimeSegment& other : grid_.segments)
      if (std::abs(other.step - step) <= tolerance * step) step = other.step;
    grid_.segments.push_back({start, step, static_cast<int>(n)});
  }

  void add(double start, double end) {
    if (!common_) return add(start, end, step_);
    grid_.segments.push_back({start, step_, static_cast<int>(std::round((end - start) / step_))});
  }

  /// Adds blocks of equal steps from start to end; the longest step depends only on the time since growth.after.
  void add_growing(double start, double end, const StepGrowth& growth) {
    const double first_block = steps_before_growth * step_, factor = growth.factor;
    while (true) {
      const double blocks = std::log1p((start - growth.after) / first_block * (factor - 1.)) / std::log(factor);
      const double wanted = step_ * std::pow(factor, std::floor(blocks + tolerance));
      const double step = std::min(wanted, std::max(step_, growth.largest));
      const double block = steps_before_growth * step;
      if (step < wanted || end - start < 2. * block) return add(start, end, step);
      grid_.segments.push_back({start, step, steps_before_growth});
      start += block;
    }
  }

 private:
  TimeGrid& grid_;
  double step_;
  bool common_;
};

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

double estimated_steps(std::size_t n_kinks, double end, double largest_step, const std::optional<StepGrowth>& growth) {
  const double kinks = static_cast<double>(n_kinks);
  if (!growth) return end / largest_step + kinks;
  const double grown = std::max(growth->largest, largest_step);
  return growth->after / largest_step + (end - growth->after) / grown + kinks +
         steps_before_growth * (1. + std::log(grown / largest_step) / std::log(growth->factor));
}

TimeGrid make_time_grid(std::vector<double> kinks, double end, double largest_step,
                        const std::optional<StepGrowth>& growth) {
  if (!(end > 0. && largest_step > 0.)) throw std::invalid_argument("a time grid needs end > 0 and a step > 0");
  if (!(estimated_steps(kinks.size(), end, largest_step, growth) < std::numeric_limits<int>::max() / 4.))
    throw std::invalid_argument("a time grid of more steps than an int can count");
  const std::vector<double> corner = corners(std::move(kinks), end);
  const auto grows = [&](double start) { return growth && start >= growth->after - tolerance * end; };
  std::vector<double> even;  // corners of the part that may have a common step
  for (double time : corner) {
    even.push_back(time);
    if (grows(time)) break;
  }
  const double common = even.size() > 1 ? common_step(even, largest_step) : 0.;
  TimeGrid grid;
  grid.end = end;
  GridBuilder builder(grid, common > 0. ? common : largest_step, common > 0.);
  for (std::size_t i = 0; i + 1 < corner.size(); ++i) {
    if (grows(corner[i])) {
      builder.add_growing(corner[i], corner[i + 1], *growth);
    } else {
      builder.add(corner[i], corner[i + 1]);
    }
  }
  return grid;
}

bool keeps_value(const TimeFunction& f, double t, double h) {
  for (double steps : {1., 2.3, 7.1})
    if (f(t + steps * h) != f(t)) return false;
  return true;
}

std::vector<double> kinks(const System& system) {
  std::vector<double> list;
  for (const SystemLoad& load : system.loads)
    list.insert(list.end(), load.history.kinks().begin(), load.history.kinks().end());
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<TimeFunction> load_histories(const System& system) {
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  return histories;
}

}  // namespace upbead
