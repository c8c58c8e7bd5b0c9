// Progress of a study, of all its processes, for a person at a terminal.
#pragma once

#include "base/stopwatch.h"

namespace upbead {

class StudyProgress {
 public:
  /// `n`: number of runs to be done.
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
