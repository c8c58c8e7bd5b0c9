#include "material/densification.h"

#include <algorithm>
#include <cmath>

namespace upbead {

namespace {

/// A smaller return, over the length of the half cycle, is no reversal: its effect is negligible beside the half
/// cycle.
constexpr double least_return = 1e-3;
/// A smaller growth is rounding: without this limit, a shear that only turns its direction would never reverse.
constexpr double least_growth = 1e-9;
/// Number of nested half cycles that are remembered. Beyond it, the outermost are forgotten and count as they are.
constexpr std::size_t most_open = 16;

}  // namespace

double ShearCompaction::of_half_cycle(double amplitude, double so_far) const {
  return amplitude > threshold ? 0.5 * amplitude * c1 * std::exp(-c2 * so_far / amplitude) : 0.;
}

double ShearCycles::distance(const Point& a, const Point& b) {
  return std::hypot(a.difference - b.difference, a.gamma - b.gamma);
}

double ShearCycles::along(const HalfCycle& half, const Point& now) {
  if (half.reached == 0.) return 0.;
  return ((half.farthest.difference - half.from.difference) * (now.difference - half.from.difference) +
          (half.farthest.gamma - half.from.gamma) * (now.gamma - half.from.gamma)) /
         half.reached;
}

void ShearCycles::reach(const Point& now, double distance) {
  HalfCycle& half = open_.back();
  compaction_ += law_.of_half_cycle(0.5 * distance, half.before) - law_.of_half_cycle(0.5 * half.reached, half.before);
  half.farthest = now;
  half.reached = distance;
  largest_ = std::max(largest_, 0.5 * distance);
}

/// When a loop returns to the point where it left the half cycle two before it, that half cycle goes on.
void ShearCycles::close_loop() {
  const HalfCycle& out = open_[open_.size() - 2];
  if (open_.back().reached < out.reached) reach(out.from, out.reached);
  open_.resize(open_.size() - 2);
}

void ShearCycles::add(const PlaneStrain& strain) {
  const Point now{strain.xx - strain.yy, 2. * strain.xy};
  if (along(open_.back(), now) < (1. - least_return) * open_.back().reached) {
    const Point turned = open_.back().farthest;
    ++reversals_;
    if (open_.size() == most_open) open_.erase(open_.begin());
    open_.push_back({turned, turned, 0., compaction_});
  }
  while (open_.size() > 2) {
    const HalfCycle& way = open_[open_.size() - 3];
    if (along(way, now) <= (1. + least_growth) * way.reached) break;
    close_loop();
  }
  const double far = distance(now, open_.back().from);
  if (far > (1. + least_growth) * open_.back().reached) reach(now, far);
}

}  // namespace upbead
