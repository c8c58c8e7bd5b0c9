#include "panel_entries.h"

#include <algorithm>
#include <limits>
#include <utility>

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

}  // namespace upbead::detail
