// Functions of time at the end of a run.
#pragma once

#include "upbead/base/time_function.h"

namespace upbead {

/// f(t) in a run until `end`, at which f has its limit from before: a record that ends with the run acts till then.
inline double until_end(const TimeFunction& f, double t, double end) {
  constexpr double hair = 1e-9;
  return t < end ? f(t) : f(t, end * (1. - hair));
}

}  // namespace upbead
