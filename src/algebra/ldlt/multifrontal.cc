#include "multifrontal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "algebra/ldlt/slabs.h"
#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

/// Calls see(source, row, column) for the lower triangle, in elimination order with row >= column.
template <class See>
void for_each_entry(const SparseMatrix& A, const std::vector<int>& position, const See& see) {
  for (int i = 0; i < A.rows(); ++i)
    for (int q = A.outerIndexPtr()[i]; q < A.outerIndexPtr()[i + 1]; ++q) {
      const int j = A.innerIndexPtr()[q];
      if (j > i) continue;
      const auto [column, row] = std::minmax(position[i], position[j]);
      see(q, row, column);
    }
}

int place_in_panel(const Supernodes& nodes, int s, int row, int column) {
  const auto begin = nodes.rows.begin() + nodes.row_begin[s], end = begin + nodes.height(s);
  const int local =
      row < nodes.first[s + 1] ? row - nodes.first[s] : static_cast<int>(std::lower_bound(begin, end, row) - begin);
  return local + (column - nodes.first[s]) * nodes.height(s);
}

void check_sizes(const Supernodes& nodes) {
  for (int s = 0; s < nodes.count(); ++s)
    if (long{nodes.width(s)} * nodes.height(s) > std::numeric_limits<int>::max())
      throw NumericsError("the matrix is too large: its factor has a panel of more than 2^31 entries");
}

}  // namespace

PanelEntries find_panel_entries(const SparseMatrix& A, const Supernodes& nodes) {
  check_sizes(nodes);
  const std::size_t n = nodes.order.size();
  std::vector<int> position(n), supernode_of(n);
  for (std::size_t k = 0; k < n; ++k) position[nodes.order[k]] = static_cast<int>(k);
  for (int s = 0; s < nodes.count(); ++s)
    for (int k = nodes.first[s]; k < nodes.first[s + 1]; ++k) supernode_of[k] = s;

  PanelEntries panels;
  panels.begin.assign(static_cast<std::size_t>(nodes.count()) + 1, 0);
  for_each_entry(A, position, [&](int, int, int column) { ++panels.begin[supernode_of[column] + 1]; });
  for (int s = 0; s < nodes.count(); ++s) panels.begin[s + 1] += panels.begin[s];
  panels.entries.resize(static_cast<std::size_t>(panels.begin.back()));
  std::vector<int> next(panels.begin.begin(), panels.begin.end() - 1);
  for_each_entry(A, position, [&](int source, int row, int column) {
    const int s = supernode_of[column];
    panels.entries[next[s]++] = {source, place_in_panel(nodes, s, row, column)};
  });
  return panels;
}

namespace {

/// The working data of one factorisation.
class Multifrontal {
 public:
  Multifrontal(const Supernodes& nodes, const PanelEntries& entries, const double* values,
               const std::vector<int>& signs)
      : nodes_(nodes),
        entries_(entries),
        values_(values),
        signs_(signs),
        first_child_(static_cast<std::size_t>(nodes.count()), -1),
        next_sibling_(first_child_),
        left_(first_child_.size()),
        place_(nodes.order.size()) {}

  void eliminate_all(Factor& factor) {
    double* out = factor.entries.get();
    factor.n_stand_ins = 0;
    for (int s = 0; s < nodes_.n_eliminated(); ++s) {
      gather(s);
      const Panel panel{columns_.data(), nodes_.height(s), nodes_.width(s)};
      factor.n_stand_ins += eliminate(s, panel);
      write_slabs(panel, sign_.data(), factor.inverse_pivot.data() + nodes_.first[s], out, work_);
      out += n_slab_entries(panel.height, panel.width);
      if (const int parent = nodes_.parent[s]; parent >= 0) {
        next_sibling_[s] = first_child_[parent];
        first_child_[parent] = s;
      }
    }
  }

  /// Once all others are eliminated.
  std::vector<double> root() {
    if (!nodes_.has_root) return {};
    gather(nodes_.count() - 1);
    return std::move(columns_);
  }

 private:
  void gather(int s) {
    const int height = nodes_.height(s), n_left = height - nodes_.width(s);
    for (int i = 0; i < height; ++i) place_[nodes_.rows[nodes_.row_begin[s] + i]] = i;
    columns_.assign(static_cast<std::size_t>(height) * nodes_.width(s), 0.);
    for (int k = entries_.begin[s]; k < entries_.begin[s + 1]; ++k)
      columns_[entries_.entries[k].place] += values_[entries_.entries[k].source];
    left_[s].assign(static_cast<std::size_t>(n_left) * n_left, 0.);
    for (int child = first_child_[s]; child >= 0; child = next_sibling_[child]) {
      add_child(s, child);
      std::vector<double>().swap(left_[child]);
    }
  }

  /// Adds the lower triangle of the child's Schur complement (extend-add).
  void add_child(int s, int child) {
    const int width = nodes_.width(s), height = nodes_.height(s), n_left = height - width;
    const int* rows = nodes_.rows.data() + nodes_.row_begin[child] + nodes_.width(child);
    const int n = nodes_.height(child) - nodes_.width(child);
    rows_of_child_.resize(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) rows_of_child_[i] = place_[rows[i]];
    for (int j = 0; j < n; ++j) {
      const double* from = left_[child].data() + std::ptrdiff_t{j} * n;
      const int column = rows_of_child_[j];
      const bool own = column < width;
      double* to = own ? columns_.data() + std::ptrdiff_t{column} * height
                       : left_[s].data() + std::ptrdiff_t{column - width} * n_left;
      const int shift = own ? 0 : width;
      for (int i = j; i < n; ++i) to[rows_of_child_[i] - shift] += from[i];
    }
  }

  /// Returns how many zero pivots were replaced.
  int eliminate(int s, const Panel& panel) {
    sign_.assign(static_cast<std::size_t>(panel.width), 1);
    if (!signs_.empty()) std::copy_n(signs_.begin() + nodes_.first[s], panel.width, sign_.begin());
    const int failed = factorise(panel, sign_.data(), work_, signs_.empty() ? 0. : stand_in);
    if (failed < panel.width) {
      const int unknown = nodes_.order[nodes_.first[s] + failed];
      if (!std::isfinite(panel.column(failed)[failed]))
        throw NumericsError("the factor of the matrix has a pivot that is not finite, at unknown " +
                            std::to_string(unknown));
      throw NumericsError("the matrix is singular: the pivot of unknown " + std::to_string(unknown) +
                          " is zero (is a part of the scene not held, or a pressure nowhere given?)");
    }
    subtract_outer_product(panel, sign_.data(), left_[s].data(), work_);
    int n = 0;
    for (int j = 0; j < panel.width; ++j) n += panel.column(j)[j] == std::sqrt(stand_in);
    return n;
  }

  const Supernodes& nodes_;
  const PanelEntries& entries_;
  const double* values_;
  const std::vector<int>& signs_;
  std::vector<int> first_child_, next_sibling_;
  std::vector<std::vector<double>> left_;  ///< per supernode: its Schur complement, until its parent has added it
  std::vector<int> place_;                 ///< per row: its place in the present front
  std::vector<double> columns_, work_;
  std::vector<int> sign_, rows_of_child_;
};

}  // namespace

Factor make_factor(const Supernodes& nodes) {
  Factor factor;
  for (int s = 0; s < nodes.n_eliminated(); ++s) factor.n_entries += n_slab_entries(nodes.height(s), nodes.width(s));
  factor.entries = make_big_array(factor.n_entries);
  factor.inverse_pivot.resize(static_cast<Eigen::Index>(nodes.order.size()) - nodes.n_root());
  return factor;
}

std::vector<double> factorise(const Supernodes& nodes, const PanelEntries& entries, const double* values,
                              Factor& factor, const std::vector<int>& signs) {
  Multifrontal work(nodes, entries, values, signs);
  work.eliminate_all(factor);
  return work.root();
}

}  // namespace upbead::detail
