// One line on stderr that says how far a long activity is. Only a person at a terminal sees it: nothing is written
// where stderr is a file or a pipe.
#pragma once

#include <string>

#include "base/stopwatch.h"

namespace upbead {

class Progress {
 public:
  /// `what`: the activity, such as "marching".
  explicit Progress(std::string what);
  /// Clears the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done`: 0 to 1. Draws at most ten times a second, so that it may be called at every step.
  void update(double done);

 private:
  std::string what_;
  bool visible_;
  Stopwatch watch_;
  double drawn_at_ = -1.;  ///< s on the watch; negative before the first line
};

/// "marching: 42 %, 12 s left"; no time left is said in the first second, when it would be a guess. `elapsed` in s.
std::string progress_line(const std::string& what, double done, double elapsed);

}  // namespace upbead
