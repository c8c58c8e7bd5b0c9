// The numeric factorisation of a sparse symmetric matrix.
#pragma once

#include <vector>

#include "algebra/big_array.h"
#include "algebra/ldlt/supernodes.h"

namespace upbead::detail {

/// For each supernode, the entries of A in its columns, so that assembly of other values needs no search.
struct PanelEntries {
  struct Entry {
    int source;  ///< among the stored values of A
    int place;   ///< in the panel (height x width, by columns) of the supernode
  };
  std::vector<int> begin;  ///< where the entries of each supernode begin; their number at the end
  std::vector<Entry> entries;
};

/// Entries of the lower triangle of A; `nodes` were found from the pattern of A.
PanelEntries find_panel_entries(const SparseMatrix& A, const Supernodes& nodes);

/// Magnitude of a pivot that replaces zero, half of the digits of a double: iterative refinement corrects the change
/// of the matrix, and the round-off that the small pivot causes.
constexpr double stand_in = 1e-8;

/// P A P^T = L D L^T, L of unit diagonal, of the supernodes that are eliminated.
struct Factor {
  BigArray entries;           ///< their slabs, one after the other
  std::size_t n_entries = 0;  ///< number of entries, including the zeros that pad them
  Vector inverse_pivot;       ///< 1 / D, in elimination order
  int n_stand_ins = 0;        ///< number of zero pivots that were replaced: L D L^T is not A there
};

/// Memory for the factor with this pattern.
Factor make_factor(const Supernodes& nodes);

/// The multifrontal method (Duff & Reid, ACM Trans. Math. Softw. 9 (1983) 302): each supernode gathers its entries of
/// A and the Schur complements of its children, eliminates its columns by signed Cholesky, and passes its own Schur
/// complement to its parent. `values` are those of A, equilibrated. `signs`, where given, are the signs that pivots
/// should have, in elimination order; then +-stand_in replaces a zero pivot (static pivoting: Li and Demmel, ACM Trans.
/// Math. Softw. 29 (2003) 110). Returns what is left in the root, the Schur complement S (n_root x n_root, lower
/// triangle). Throws NumericsError on a pivot that is not finite, or zero.
std::vector<double> factorise(const Supernodes& nodes, const PanelEntries& entries, const double* values,
                              Factor& factor, const std::vector<int>& signs = {});

}  // namespace upbead::detail
