#include "algebra/pattern_sums.h"

#include <algorithm>
#include <cmath>

namespace upbead::detail {

namespace {

/// Marks an entry to which nothing was added: -0 + x = x, and no sum of other numbers is -0.
constexpr double untouched = -0.;

bool is_touched(double value) {
  return value != 0. || !std::signbit(value);
}

/// The groups of each unknown: those of i are group[first[i]], ... group[first[i + 1] - 1].
struct GroupsOf {
  std::vector<std::size_t> first;
  std::vector<int> group;

  GroupsOf(int n, const std::vector<std::vector<int>>& groups) : first(static_cast<std::size_t>(n) + 1, 0) {
    for (const std::vector<int>& unknowns : groups)
      for (const int i : unknowns) ++first[static_cast<std::size_t>(i) + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    group.resize(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const int i : groups[g]) group[next[static_cast<std::size_t>(i)]++] = static_cast<int>(g);
  }
};

}  // namespace

PatternSums::PatternSums(int n, int n_matrices, const std::vector<std::vector<int>>& groups)
    : n_matrices_(static_cast<std::size_t>(n_matrices)), place_(static_cast<std::size_t>(n)) {
  make_pattern(groups);
  values_.assign(n_matrices_ * column_.size(), untouched);
}

void PatternSums::make_pattern(const std::vector<std::vector<int>>& groups) {
  const std::size_t n = place_.size();
  const GroupsOf of(static_cast<int>(n), groups);
  std::vector<int> seen_by(n, -1);
  first_.push_back(0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t g = of.first[i]; g < of.first[i + 1]; ++g)
      for (const int j : groups[static_cast<std::size_t>(of.group[g])])
        if (seen_by[static_cast<std::size_t>(j)] != static_cast<int>(i)) {
          seen_by[static_cast<std::size_t>(j)] = static_cast<int>(i);
          column_.push_back(j);
        }
    std::sort(column_.begin() + static_cast<std::ptrdiff_t>(first_.back()), column_.end());
    first_.push_back(column_.size());
  }
}

void PatternSums::begin_row(int row) {
  if (row == row_) return;
  row_ = row;
  const auto i = static_cast<std::size_t>(row);
  for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
    place_[static_cast<std::size_t>(column_[k])] = n_matrices_ * k;
}

SparseMatrix PatternSums::matrix(int which) const {
  const auto n = static_cast<Eigen::Index>(place_.size());
  const auto value = [&](std::size_t k) { return values_[n_matrices_ * k + static_cast<std::size_t>(which)]; };
  Eigen::Index n_entries = 0;
  for (std::size_t k = 0; k < column_.size(); ++k) n_entries += is_touched(value(k)) ? 1 : 0;
  SparseMatrix A(n, n);
  A.reserve(n_entries);
  for (Eigen::Index i = 0; i < n; ++i) {
    A.startVec(i);
    for (std::size_t k = first_[static_cast<std::size_t>(i)]; k < first_[static_cast<std::size_t>(i) + 1]; ++k)
      if (is_touched(value(k))) A.insertBack(i, column_[k]) = value(k);
  }
  A.finalize();
  return A;
}

}  // namespace upbead::detail
