// Where the entries of a sparse matrix go in the panels of its factor.
#pragma once

#include <vector>

#include "supernodes.h"

namespace upbead::detail {

/// For each supernode, the entries of A in its columns, so that assembling other values needs no search.
struct PanelEntries {
  struct Entry {
    int source;  ///< among the stored values of A
    int place;   ///< in the panel (height x width, by columns) of the supernode
  };
  std::vector<int> begin;  ///< where the entries of each supernode begin; their number at the end
  std::vector<Entry> entries;
};

/// Of the lower triangle of A, whose pattern `nodes` were found from.
PanelEntries find_panel_entries(const SparseMatrix& A, const Supernodes& nodes);

}  // namespace upbead::detail
