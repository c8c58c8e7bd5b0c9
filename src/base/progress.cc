#include "base/progress.h"

#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

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

Progress::Progress(std::string what) : what_(std::move(what)), visible_(isatty(STDERR_FILENO) == 1) {}

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

std::function<void(double)> watched(const std::string& what) {
  return [line = std::make_shared<Progress>(what)](double done) {
    check_interrupt();
    line->update(done);
  };
}

std::function<void(double)> part_of(const std::function<void(double)>& progress, double from, double to) {
  if (!progress) return {};
  return [progress, from, to](double done) { progress(from + (to - from) * done); };
}

namespace {

/// The pieces that no thread has taken yet, and the first exception.
class Pieces {
 public:
  Pieces(std::size_t n, const std::function<void(std::size_t)>& work) : n_(n), work_(work) {}

  /// Works until no piece is left. After each piece of this thread, `after` is called with the share of pieces taken
  /// so far.
  void take(const std::function<void(double)>& after) {
    try {
      for (std::size_t i = next_++; i < n_; i = next_++) {
        work_(i);
        after(static_cast<double>(i + 1) / static_cast<double>(n_));
      }
    } catch (...) {
      next_ = n_;
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::size_t n_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void in_parallel(std::size_t n, const std::string& what, const std::function<void(std::size_t)>& work) {
  Pieces pieces(n, work);
  std::vector<std::thread> others;
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  for (std::size_t i = 1; i < std::min(n, cores); ++i) others.emplace_back([&pieces] { pieces.take([](double) {}); });
  Progress progress(what);
  pieces.take([&progress](double done) {  // only the calling thread draws the line
    check_interrupt();
    progress.update(done);
  });
  for (std::thread& other : others) other.join();
  pieces.rethrow();
}

}  // namespace upbead
