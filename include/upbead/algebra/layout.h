// How vectors lie on the processes that work on one problem together.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "upbead/algebra/processes.h"
#include "upbead/algebra/sparse.h"

namespace upbead {

/// A vector of values has an entry for each unknown that a process holds, the same on all that hold it; one process
/// counts for each unknown. Parts are what sums over all processes to a whole. A process that is alone has the whole:
/// there nothing is done. All processes make the same calls.
class Layout {
 public:
  Layout() = default;  ///< of a process that is alone
  /// `elsewhere`: indices of the unknowns for which another process counts, ascending.
  Layout(std::shared_ptr<const Processes> processes, std::vector<int> elsewhere)
      : processes_(std::move(processes)), elsewhere_(std::move(elsewhere)) {}

  bool is_alone() const { return processes_ == nullptr; }
  /// Replaces parts by the whole, the same to the last bit on every process.
  template <class Dense>
  void add_up(Eigen::PlainObjectBase<Dense>& parts) const {
    if (processes_) processes_->sum(parts.data(), static_cast<int>(parts.size()));
  }
  double sum(double part) const {
    if (processes_) processes_->sum(&part, 1);
    return part;
  }
  /// Replaces values by those of the first process: what all decide by them, they decide alike.
  void take_first(double* values, std::size_t n) const;
  void take_first(std::vector<double>& values) const { take_first(values.data(), values.size()); }
  void take_first(double& value) const { take_first(&value, 1); }
  bool first_says(bool value) const;
  /// The largest of one number of each process, which is not below 0.
  double largest(double value) const;
  /// Values without those for which another process counts: parts of the whole vector.
  Vector counted(const Vector& values) const;
  /// V^T y over all unknowns, for values.
  Vector products(const Eigen::Ref<const Eigen::MatrixXd>& V, const Vector& y) const;
  /// |y|^2 over all unknowns, for values.
  double square(const Vector& y) const;
  double norm(const Vector& y) const;
  /// y/|y|, or zero.
  Vector normalised(const Vector& y) const;
  /// Of some of the unknowns, whose indices ascend.
  Layout of(const std::vector<int>& unknowns) const;

 private:
  std::shared_ptr<const Processes> processes_;  ///< null: alone
  std::vector<int> elsewhere_;
};

}  // namespace upbead
