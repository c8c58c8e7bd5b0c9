// When a phase of a slip ends.
#pragma once

#include "dynamics/slip_path.h"
#include "dynamics/slip_steps.h"

namespace upbead::detail {

enum class SlipEvent {
  none,
  starts,  ///< |F_T| reaches mu N'
  stops,   ///< s' = 0
  lifts,   ///< N' = 0, falling
  lands    ///< N' = 0, rising
};

struct TimedEvent {
  SlipEvent event = SlipEvent::none;
  double time = 0.;  ///< from the start of the stretch (s)
};

/// 1 forward, -1 backward, else 0.
inline double direction(BottomState contact) {
  return contact == BottomState::forward ? 1. : contact == BottomState::backward ? -1. : 0.;
}

/// Which event shows at a time, by its readings: F_T where it sticks, s' where it slips; and N'.
SlipEvent event_at(BottomState contact, double friction, double watched, double normal);

/// The event that shows at an end of a path, and when it came. `fresh`: the phase has begun with the path, so that s',
/// or |F_T| - mu N', is zero up to round-off.
TimedEvent first_event(const SlipPath& path, BottomState contact, double friction, bool fresh);

}  // namespace upbead::detail
