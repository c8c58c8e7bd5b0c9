// Where a cell meets two smaller ones.
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include "fem/space.h"

namespace upbead {

/// u and phi of the smaller cells follow the larger cell's shape functions on their common side. Both are of one kind:
/// surfaces meet without hanging nodes (see mesh/refine.h).
void add_hanging_nodes(dealii::AffineConstraints<double>& constraints, const Space& space);

}  // namespace upbead
