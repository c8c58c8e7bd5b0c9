// The loads of a system at one time.
#pragma once

#include <vector>

#include "upbead/system/system.h"

namespace upbead::detail {

/// Evaluates the loads of a system as the smooth pieces that hold a given time.
class LoadSum {
 public:
  explicit LoadSum(const System& system) : system_(system) {}

  /// f_k(t) of every load, by the piece that holds the time `inside`.
  void evaluate(double t, double inside, std::vector<double>& f) const;
  /// sum_k b_k f_k.
  void sum(const std::vector<double>& f, Vector& b) const;
  /// The prescribed unknowns' velocities (the tail of `v`) that belong to f; zero where no load prescribes.
  void prescribe(const std::vector<double>& f, Vector& v) const;

 private:
  const System& system_;
};

}  // namespace upbead::detail
