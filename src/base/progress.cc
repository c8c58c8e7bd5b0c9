#include "base/progress.h"

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "base/crew.h"
#include "base/interrupt.h"

namespace upbead {

namespace {
constexpr double redraw_after = 0.1;        // s
constexpr const char* clear = "\r\033[2K";  // back to the first column, erase the line

std::string duration_text(double seconds) {
  const long s = std::lround(std::ceil(seconds));
  if (s < 120) return std::to_string(s) + " s";
  if (s < 7200) return std::to_string((s + 30) / 60) + " min";
  return std::to_string((s + 1800) / 3600) + " h";
}
}  // namespace

std::string progress_line(const std::string& what, double done, double elapsed) {
  done = std::clamp(done, 0., 1.);
  std::string line = what + ": " + std::to_string(static_cast<int>(100. * done)) + " %";
  if (elapsed >= 1. && done > 0.) line += ", " + duration_text(elapsed * (1. - done) / done) + " left";
  return line;
}

Progress::Progress(std::string what)
    : what_(std::move(what)), visible_(isatty(STDERR_FILENO) == 1 || std::getenv(progress_through_pipe) != nullptr) {}

Progress::~Progress() {
  if (drawn_at_ >= 0.) std::fputs(clear, stderr);
}

void Progress::update(double done) {
  done_ = std::max(done_, done);
  if (!visible_) return;
  const double now = watch_.seconds();
  if (drawn_at_ >= 0. && now - drawn_at_ < redraw_after) return;
  std::fputs((clear + progress_line(what_, done_, now)).c_str(), stderr);
  drawn_at_ = now;
}

std::function<void(double)> shown_progress(const std::string& what) {
  return [line = std::make_shared<Progress>(what)](double done) {
    check_interrupt();
    line->update(done);
  };
}

std::function<void(double)> part_of(const std::function<void(double)>& progress, double from, double to) {
  if (!progress) return {};
  return [progress, from, to](double done) { progress(from + (to - from) * done); };
}

void in_parallel(std::size_t n, const std::string& what, const std::function<void(std::size_t)>& work) {
  Progress progress(what);
  Crew(static_cast<int>(std::min<std::size_t>(n, most_threads())))
      .share(
          static_cast<int>(n), [&work](int i) { work(static_cast<std::size_t>(i)); },
          [&progress](double done) {
            check_interrupt();
            progress.update(done);
          });
}

}  // namespace upbead
