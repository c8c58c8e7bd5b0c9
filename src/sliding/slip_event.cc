#include "slip_event.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace upbead::detail {

namespace {

/// f(from) >= 0 > f(to); the end of the last bracket where f < 0, or next to it.
template <class Function>
double root(const Function& f, double from, double to) {
  boost::uintmax_t most = 100;
  return boost::math::tools::toms748_solve(f, from, to, boost::math::tools::eps_tolerance<double>(46), most).second;
}

/// Where f, which is negative at `length`, has become so; at once where it is already.
template <class Function>
double crossing(const Function& f, double length) {
  return f(0.) > 0. ? root(f, 0., length) : 0.;
}

/// The same where f(0) is zero, up to round-off, and f may yet rise.
template <class Function>
double return_to_zero(const Function& f, double length) {
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i, length *= 0.5)
    if (f(0.5 * length) > 0.) return root(f, 0.5 * length, length);
  return 0.;
}

}  // namespace

SlipEvent event_at(BottomState contact, double friction, double watched, double normal) {
  switch (contact) {
    case BottomState::stuck:
      return std::abs(watched) > friction * normal ? SlipEvent::starts : SlipEvent::none;
    case BottomState::lifted:
      return normal > 0. ? SlipEvent::lands : SlipEvent::none;
    default:
      if (normal < 0.) return SlipEvent::lifts;
      return direction(contact) * watched < 0. ? SlipEvent::stops : SlipEvent::none;
  }
}

TimedEvent first_event(const SlipPath& path, BottomState contact, double friction, bool fresh) {
  const double length = path.length();
  const SlipCurve normal = path.reading(row_normal), watched = path.reading(SlipSteps::watched_row(contact));
  const SlipEvent at_end = event_at(contact, friction, watched(length), normal(length));
  if (!fresh)  // loads may have jumped
    if (const SlipEvent at_once = event_at(contact, friction, watched(0.), normal(0.)); at_once != SlipEvent::none)
      return {at_once, 0.};
  if (contact == BottomState::stuck) {
    if (at_end == SlipEvent::none) return {};
    return {at_end, crossing([&](double t) { return friction * normal(t) - std::abs(watched(t)); }, length)};
  }
  if (contact == BottomState::lifted) {
    if (at_end == SlipEvent::none) return {};
    return {at_end, crossing([&](double t) { return -normal(t); }, length)};
  }
  TimedEvent first;
  if (normal(length) < 0.) first = {SlipEvent::lifts, crossing(normal, length)};
  const auto speed = [&](double t) { return direction(contact) * watched(t); };
  if (speed(length) < 0.) {
    const double stop = fresh ? return_to_zero(speed, length) : crossing(speed, length);
    if (first.event == SlipEvent::none || stop < first.time) first = {SlipEvent::stops, stop};
  }
  return first;
}

}  // namespace upbead::detail
