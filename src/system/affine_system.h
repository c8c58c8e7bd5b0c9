// A System that is a sum of parts times known factors, as are those of one scene with other soils.
#pragma once

#include <vector>

#include "upbead/system/system.h"

namespace upbead {

/// fixed + sum_q factor_q part_q: M, C, K, radiation, and the rows of the readings. All else is that of `fixed`, and
/// the parts have the same unknowns and readings. M, C and K of a part may be empty, of size 0.
struct AffineSystem {
  System fixed;
  std::vector<System> parts;

  /// Throws std::invalid_argument where there are not as many factors as parts.
  System at(const std::vector<double>& factors) const;
};

/// a + factor b of rows: sorted by unknown, without those that cancel.
Row sum(const Row& a, const Row& b, double factor);

/// What of `one` is not in `other`: matrices, and rows of readings, without entries that are equal to the last bit. Its
/// loads are zero: their vectors are empty.
System difference(const System& one, const System& other);

/// How far two systems lie apart: the largest difference of entries of M, C, K, readings and loads, over the root of
/// the product of their row's and column's largest entries; of readings and loads over their own largest entry.
double distance(const System& one, const System& other);

}  // namespace upbead
