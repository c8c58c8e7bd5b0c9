// A few threads that share work again and again, each time a short piece of it.
#pragma once

#include <functional>
#include <memory>

namespace upbead {

/// Threads wait between works.
class Crew {
 public:
  /// 0: as many threads as the process may use cores, or as OMP_NUM_THREADS says. With one the caller does all.
  explicit Crew(int n_threads = 0);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const;
  /// Calls work(i) once for every i < n, in no order, and waits for all. Throws the first exception of one. One caller
  /// at a time.
  void share(int n, const std::function<void(int)>& work);

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace upbead
