#include "study/study_progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

#include "base/progress.h"

namespace upbead {

namespace {

constexpr double redraw_after = 0.2;        // s
constexpr const char* clear = "\r\033[2K";  // back to the first column, erase the line

}  // namespace

StudyProgress::StudyProgress(int n) : n_(n), visible_(isatty(STDERR_FILENO) == 1) {}

StudyProgress::~StudyProgress() {
  if (drawn_at_ >= 0.) std::fputs(clear, stderr);
}

bool StudyProgress::due() const {
  return visible_ && (drawn_at_ < 0. || watch_.seconds() - drawn_at_ > redraw_after);
}

void StudyProgress::draw(int done, int failed) {
  std::string what = std::to_string(done) + " of " + std::to_string(n_) + " runs";
  if (failed > 0) what += ", " + std::to_string(failed) + " failed";
  drawn_at_ = watch_.seconds();
  std::fputs((clear + progress_line(what, static_cast<double>(done) / n_, drawn_at_)).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace upbead
