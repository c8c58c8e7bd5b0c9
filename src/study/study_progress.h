// The line that says how far a study is.
#pragma once

#include "base/stopwatch.h"

namespace upbead {

/// Only for a person at a terminal. Several processes work, so that each line is asked of what all of them have done.
class StudyProgress {
 public:
  /// `n`: runs that are to be done.
  explicit StudyProgress(int n);
  /// Clears the line.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  /// Whether it is time for another line.
  bool due() const;
  void draw(int done, int failed);

 private:
  int n_;
  bool visible_;
  Stopwatch watch_;
  double drawn_at_ = -1.;  ///< s on the watch; negative before the first line
};

}  // namespace upbead
