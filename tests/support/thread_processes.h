// Threads that stand for processes.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "upbead/algebra/processes.h"

namespace upbead::test {

/// Sums over the threads.
class Meeting {
 public:
  explicit Meeting(int count) : count_(count), brought_(static_cast<std::size_t>(count)) {}
  int count() const { return count_; }

  /// Adds in the order of ranks, whichever thread comes first.
  void sum(int rank, double* values, int n) {
    std::unique_lock<std::mutex> lock(mutex_);
    brought_[rank].assign(values, values + n);
    const int round = round_;
    if (++arrived_ == count_) {
      total_.assign(static_cast<std::size_t>(n), 0.);
      for (const auto& part : brought_)
        for (int i = 0; i < n; ++i) total_[i] += part[i];
      arrived_ = 0;
      ++round_;
      all_here_.notify_all();
    } else {
      all_here_.wait(lock, [&] { return round_ != round; });
    }
    std::copy(total_.begin(), total_.end(), values);
  }

 private:
  int count_, arrived_ = 0, round_ = 0;
  std::vector<std::vector<double>> brought_;
  std::vector<double> total_;
  std::mutex mutex_;
  std::condition_variable all_here_;
};

class ThreadProcesses : public Processes {
 public:
  ThreadProcesses(int rank, Meeting& meeting) : rank_(rank), meeting_(meeting) {}
  int rank() const override { return rank_; }
  int count() const override { return meeting_.count(); }
  void sum(double* values, int n) const override { meeting_.sum(rank_, values, n); }
  [[noreturn]] void end_all(int) const override { std::abort(); }

 private:
  int rank_;
  Meeting& meeting_;
};

/// Calls work(processes) from `count` threads, each of another rank.
inline void on_processes(int count, const std::function<void(const std::shared_ptr<const Processes>&)>& work) {
  Meeting meeting(count);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < count; ++rank)
    threads.emplace_back([&, rank] { work(std::make_shared<const ThreadProcesses>(rank, meeting)); });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace upbead::test
