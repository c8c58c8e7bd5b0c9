// The factor L, stored in the order in which a solve reads it.
#pragma once

#include <cstddef>
#include <vector>

#include "factor_view.h"
#include "signed_cholesky.h"

namespace upbead::detail {

/// A panel [L11; L21], scaled to a unit diagonal, is cut into slabs of up to 8 columns, from the first column on. A
/// slab begins at the row of its first column and is cut into tiles of 8 rows, padded with zeros, each stored by
/// columns. With T the triangle in the rows of a slab's own columns and R the rows below, the slab holds
///   M = [T^-1 - I; -R T^-1],
/// so that elimination is t += M t_slab and substitution t_slab += M^T t: products alone, no divisions, and no column
/// waits for another (partitioned inverse: Alvarado & Schreiber, SIAM J. Sci. Comput. 14 (1993) 446).
inline int n_tiles(int height) {
  return (height + slab_width - 1) / slab_width;
}

/// Number of entries in all slabs of a panel.
std::size_t n_slab_entries(int height, int width);

/// Writes the slabs of a factorised panel to `out` and 1 / (sign l_jj^2) to `inverse_pivot`; overwrites the panel.
void write_slabs(const Panel& factor, const int* sign, double* inverse_pivot, double* out, std::vector<double>& work);

}  // namespace upbead::detail
