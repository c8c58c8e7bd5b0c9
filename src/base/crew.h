// A few threads that share many short pieces of work.
#pragma once

#include <functional>
#include <memory>

namespace upbead {

/// The threads wait between two calls of share().
class Crew {
 public:
  /// 0: as many threads as the process may use cores, or OMP_NUM_THREADS where that is less. With one, the caller
  /// does all.
  explicit Crew(int n_threads = 0);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const;
  /// Calls work(i) once for every i < n, in no order, and waits for all. Throws the first exception of a call. Only
  /// one thread may call it at a time.
  void share(int n, const std::function<void(int)>& work);

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace upbead
