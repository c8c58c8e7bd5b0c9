#include "run/sliding/uplift_course.h"

#include <algorithm>

#include "response/slip_law.h"

namespace upbead {

bool pushes_seaward_alone(const TimeFunction& P, double end) {
  return pushes_seaward_alone(extremum(P, 0., end, 1).value, extremum(P, 0., end, -1).value);
}

namespace {

/// U follows P by `lag` while P is landward, or where it never is, while it is seaward; with the course held, U stays
/// at its peak after the peak of P.
TimeFunction follow_force(const UpliftChoice& uplift, const TimeFunction& force, double end) {
  const TimeFunction P = pushes_seaward_alone(force, end) ? scaled(force, -1.) : force;
  const Extremum largest = extremum(P, 0., end, 1);
  if (largest.value <= 0.) return {};
  const double lag = uplift.lag, peak = *uplift.peak, over = largest.time + lag;
  const bool held = uplift.course == UpliftCourse::held;
  std::vector<double> kinks{lag}, samples;
  for (const double t : P.kinks())
    if (t > 0. && (!held || t < largest.time)) kinks.push_back(t + lag);
  if (held && largest.time > 0.) kinks.push_back(over);
  for (const double t : P.samples())
    if (t >= 0. && (!held || t < largest.time)) samples.push_back(t + lag);
  std::vector<TimeFunction::Piece> pieces{[](double) { return 0.; }};
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    const double inside = (i + 1 < kinks.size() ? 0.5 * (kinks[i] + kinks[i + 1]) : kinks[i] + 1.) - lag;
    if (held && inside >= largest.time)
      pieces.emplace_back([peak](double) { return peak; });
    else
      pieces.emplace_back([=](double t) { return peak * (std::max(P(t - lag, inside), 0.) / largest.value); });
  }
  return {kinks, pieces, samples};
}

}  // namespace

TimeFunction prescribed_uplift(const UpliftChoice& uplift, const TimeFunction& P, double end) {
  return uplift.peak ? follow_force(uplift, P, end) : uplift.history;
}

}  // namespace upbead
