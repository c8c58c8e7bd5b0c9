// The numeric factorisation of a sparse symmetric matrix.
#pragma once

#include <functional>
#include <vector>

#include "algebra/big_array.h"
#include "algebra/ldlt/supernodes.h"

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

/// Half of the digits: what it changes, iterative refinement mends, and what is lost in it as well.
constexpr double stand_in = 1e-8;

/// P A P^T = L D L^T, L of unit diagonal.
struct Factor {
  BigArray entries;           ///< slabs of all supernodes, one after the other
  std::size_t n_entries = 0;  ///< their number, with the zeros that fill them up
  Vector inverse_pivot;       ///< 1 / D, in elimination order
  int n_stand_ins = 0;        ///< pivots that were zero, in whose place another one stands: L D L^T is not A there
};

/// Room for the factor that has this pattern.
Factor make_factor(const Supernodes& nodes);

/// The multifrontal method (Duff & Reid, ACM Trans. Math. Softw. 9 (1983) 302): each supernode gathers its entries of A
/// and what its children leave, eliminates its columns by signed Cholesky, and leaves its own Schur complement to its
/// parent. `values` are those of A, equilibrated. `sum_root`, where given, adds up what all processes have gathered of
/// the last supernode (its columns, the lower triangle of which counts). `signs`, where given, are those that pivots
/// should have, in elimination order; then +-stand_in takes the place of a pivot that is zero (static pivoting: Li and
/// Demmel, ACM Trans. Math. Softw. 29 (2003) 110). Throws NumericsError on a pivot that is not finite, or zero.
void factorise(const Supernodes& nodes, const PanelEntries& entries, const double* values, Factor& factor,
               const std::function<void(std::vector<double>& columns)>& sum_root = {},
               const std::vector<int>& signs = {});

}  // namespace upbead::detail
