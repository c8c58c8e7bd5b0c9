#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/interrupt.h"
#include "base/progress.h"

namespace upbead {

namespace {

/// The pieces that nobody has taken yet, and the first thing that went wrong.
class Pieces {
 public:
  Pieces(std::size_t n, const std::function<void(std::size_t)>& work) : n_(n), work_(work) {}

  /// Works until no piece is left. `after` is called after every piece of this thread with the part that is taken.
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
  pieces.take([&progress](double done) {  // this thread alone talks to the person
    check_interrupt();
    progress.update(done);
  });
  for (std::thread& other : others) other.join();
  pieces.rethrow();
}

}  // namespace upbead
