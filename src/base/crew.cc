#include "base/crew.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/cores.h"

namespace upbead {

int most_threads() {
  const int there = available_cores();
  const char* told = std::getenv("OMP_NUM_THREADS");
  const int wanted = told ? std::atoi(told) : there;
  return wanted > 0 ? std::min(wanted, there) : there;
}

struct Crew::Threads {
  explicit Threads(int all) : size(all) {
    for (int i = 1; i < all; ++i) others.emplace_back([this] { serve(); });
  }
  ~Threads() {
    {
      const std::lock_guard lock(mutex);
      ends = true;
    }
    called.notify_all();
    for (std::thread& other : others) other.join();
  }
  void serve() {
    for (long seen = 0;;) {
      std::unique_lock lock(mutex);
      called.wait(lock, [&] { return ends || call != seen; });
      if (ends) return;
      seen = call;
      lock.unlock();
      take({});
      lock.lock();
      if (--busy == 0) done.notify_one();
    }
  }
  /// Works on pieces until none is left; after each call, `after` is told the share of calls begun so far.
  void take(const std::function<void(double)>& after) {
    try {
      for (int begin = next.fetch_add(piece); begin < n; begin = next.fetch_add(piece))
        for (int i = begin; i < std::min(n, begin + piece); ++i) {
          (*work)(i);
          if (after) after((i + 1.) / n);
        }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
      next = n;
    }
  }

  int size;
  std::vector<std::thread> others;
  std::mutex mutex;
  std::condition_variable called, done;
  long call = 0;  ///< number of calls of share()
  int busy = 0, n = 0, piece = 1;
  std::atomic<int> next{0};
  bool ends = false;
  const std::function<void(int)>* work = nullptr;
  std::exception_ptr error;
};

Crew::Crew(int n_threads) : threads_(std::make_unique<Threads>(n_threads > 0 ? n_threads : most_threads())) {}
Crew::~Crew() = default;

int Crew::size() const {
  return threads_->size;
}

void Crew::share(int n, const std::function<void(int)>& work, const std::function<void(double)>& after) {
  constexpr int pieces_of_a_thread = 8;
  Threads& t = *threads_;
  {
    const std::lock_guard lock(t.mutex);
    t.n = n;
    t.work = &work;
    t.error = nullptr;
    t.next = 0;
    t.piece = after ? 1 : std::max(1, n / (pieces_of_a_thread * t.size));
    t.busy = t.size - 1;
    ++t.call;
  }
  t.called.notify_all();
  t.take(after);
  std::unique_lock lock(t.mutex);
  t.done.wait(lock, [&] { return t.busy == 0; });
  if (t.error) std::rethrow_exception(t.error);
}

}  // namespace upbead
