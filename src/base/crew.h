// A few threads that share many pieces of work.
#pragma once

#include <functional>
#include <memory>

namespace upbead {

/// As many threads as the process may use cores, or OMP_NUM_THREADS where that is less.
int most_threads();

/// The threads wait between two calls of share().
class Crew {
 public:
  /// 0: most_threads(). With one, the caller does all.
  explicit Crew(int n_threads = 0);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const;
  /// Calls work(i) once for every i < n, in no order, and waits for all. Throws the first exception of a call, after
  /// which none begins. Only one thread may call it at a time. `after`, of long work: called by that thread after each
  /// of its calls, with the share of calls begun; may throw, as where a signal was noted.
  void share(int n, const std::function<void(int)>& work, const std::function<void(double)>& after = {});

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace upbead
