// The numeric factorisation of a sparse symmetric matrix.
#pragma once

#include <functional>
#include <vector>

#include "big_array.h"
#include "panel_entries.h"

namespace upbead::detail {

/// P A P^T = L D L^T, L of unit diagonal.
struct Factor {
  BigArray entries;           ///< slabs of all supernodes, one after the other
  std::size_t n_entries = 0;  ///< their number, with the zeros that fill them up
  Vector inverse_pivot;       ///< 1 / D, in elimination order
};

/// Room for the factor that has this pattern.
Factor make_factor(const Supernodes& nodes);

/// The multifrontal method (Duff & Reid, ACM Trans. Math. Softw. 9 (1983) 302): each supernode gathers its entries of A
/// and what its children leave, eliminates its columns by signed Cholesky, and leaves its own Schur complement to its
/// parent. `values` are those of A, equilibrated. `sum_root`, where given, adds up what all processes have gathered of
/// the last supernode (its columns, the lower triangle of which counts). Throws NumericsError on a pivot that is zero
/// or not finite.
void factorise(const Supernodes& nodes, const PanelEntries& entries, const double* values, Factor& factor,
               const std::function<void(std::vector<double>& columns)>& sum_root = {});

}  // namespace upbead::detail
