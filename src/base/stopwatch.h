// Wall time of one activity.
#pragma once

#include <chrono>

namespace upbead {

class Stopwatch {
 public:
  /// Wall time since construction (s).
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace upbead
