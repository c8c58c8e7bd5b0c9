// Long work: one line on stderr that says how far it is, and independent pieces of it on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "base/stopwatch.h"

namespace upbead {

/// Only a person at a terminal sees the line: nothing is written where stderr is a file or a pipe.
class Progress {
 public:
  /// `what`: the activity, such as "marching".
  explicit Progress(std::string what);
  /// Clears the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done`: 0 to 1; where work begins anew the largest so far stays. Draws at most ten times a second, so that it may
  /// be called at every step.
  void update(double done);

 private:
  std::string what_;
  bool visible_;
  Stopwatch watch_;
  double done_ = 0.;       ///< the largest so far
  double drawn_at_ = -1.;  ///< s on the watch; negative before the first line
};

/// Tells how far the whole is from how far its part from `from` to `to` is; null of null.
std::function<void(double)> part_of(const std::function<void(double)>& progress, double from, double to);

/// "marching: 42 %, 12 s left"; no time left is said in the first second, when it would be a guess. `elapsed` in s.
std::string progress_line(const std::string& what, double done, double elapsed);

/// Calls work(i) once for every i < n, from several threads, and shows how far it is as `what`. Throws the first
/// exception that a piece throws, and Interrupted; no piece begins after it.
void in_parallel(std::size_t n, const std::string& what, const std::function<void(std::size_t)>& work);

}  // namespace upbead
