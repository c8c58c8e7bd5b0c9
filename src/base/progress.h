// Long work: a line on stderr that shows its progress, and independent pieces of work on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "base/stopwatch.h"

namespace upbead {

/// Environment variable of a process whose stderr is a pipe to one that shows its progress, see child_program.h.
constexpr const char* progress_through_pipe = "UPBEAD_PROGRESS_THROUGH_PIPE";

/// The line is for a person at a terminal: nothing is written where stderr is a file or a pipe.
class Progress {
 public:
  /// `what`: the activity, such as "marching".
  explicit Progress(std::string what);
  /// Clears the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done`: 0 to 1; the line never goes back, also where work begins anew. Draws at most ten times a second, so that
  /// it may be called at every step.
  void update(double done);

 private:
  std::string what_;
  bool visible_;
  Stopwatch watch_;
  double done_ = 0.;       ///< the largest so far
  double drawn_at_ = -1.;  ///< s on the watch; negative before the first line
};

/// A function to be called with the share of long work that is done: shows it as `what`, and throws Interrupted where a
/// signal has been noted. The line goes with the last copy of the function.
std::function<void(double)> shown_progress(const std::string& what);

/// A function that takes the progress of a part of the work, from `from` to `to`, and passes on that of the whole;
/// null if `progress` is null.
std::function<void(double)> part_of(const std::function<void(double)>& progress, double from, double to);

/// "marching: 42 %, 12 s left"; without the time left in the first second, when it would be a guess. `elapsed` in s.
std::string progress_line(const std::string& what, double done, double elapsed);

/// Calls work(i) once for every i < n, from several threads, and shows the progress with `what`. Throws the first
/// exception of a call, or Interrupted; no further piece begins then.
void in_parallel(std::size_t n, const std::string& what, const std::function<void(std::size_t)>& work);

}  // namespace upbead
