// One unknown more than a system has: how far a body slips, by its row of the equations.
#pragma once

#include <cmath>
#include <vector>

#include "upbead/system/system.h"

namespace upbead {

/// Where a caisson slips as a whole, the ground's nodes at its bottom move with it but for one slip s. While s = 0 the
/// system is the bonded one: M, C and K have the row of s more, and the same column,
///
///     (bonded   row^T)
///     (row      own  ),
///
/// and the residual of that row is -F_T. So the bonded system and this row are all that there is to know.
struct SlipRow {
  Row M, C, K;                                           ///< in the unknowns of the bonded system
  double m = 0., c = 0., k = 0.;                         ///< on the diagonal
  double unit = 1.;                                      ///< the unknown is s over this unit
  std::vector<double> load;                              ///< by load of the bonded system
  std::vector<double> position, velocity, acceleration;  ///< weights in its readings

  /// A unit of the unknown in which it counts as others do, 1/sqrt(t_ss(s_0)).
  double unit_about(double shift) const {
    const double own = shift * (shift * m + c) + k;
    return own > 0. ? 1. / std::sqrt(own) : 1.;
  }
};

/// The row of the unknown that slips, of a system with what add_slip() adds. Only what stands in that row is looked at,
/// and in the readings.
SlipRow slip_row(const System& slipping);

}  // namespace upbead
