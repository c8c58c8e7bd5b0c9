#include "hanging_nodes.h"

#include <algorithm>
#include <cmath>

#include "fem/faces.h"

namespace upbead {

using namespace dealii;

namespace {

/// The degrees of freedom on a side of a smaller cell that the larger one does not have follow its shape functions.
void follow(AffineConstraints<double>& constraints, const Space& space, const Cell& small, unsigned side,
            const Cell& large) {
  const auto& fe = small->get_fe();
  std::vector<types::global_dof_index> of_small(fe.n_dofs_per_cell()), of_large(large->get_fe().n_dofs_per_cell());
  small->get_dof_indices(of_small);
  large->get_dof_indices(of_large);
  for (unsigned i = 0; i < fe.n_dofs_per_face(side); ++i) {
    const unsigned index = fe.face_to_cell_index(i, side);
    const auto dof = of_small[index];
    if (constraints.is_constrained(dof) || std::find(of_large.begin(), of_large.end(), dof) != of_large.end()) continue;
    const auto [component, node] = fe.system_to_component_index(index);
    const auto& base = fe.base_element(fe.component_to_base_index(component).first);
    const Point<dim> at = space.mapping().transform_unit_to_real_cell(small, base.unit_support_point(node));
    const Point<dim> unit = space.mapping().transform_real_to_unit_cell(large, at);
    constraints.add_line(dof);
    for (unsigned j = 0; j < of_large.size(); ++j)
      if (large->get_fe().system_to_component_index(j).first == component)
        if (const double weight = large->get_fe().shape_value(j, unit); std::abs(weight) > 1e-12)
          constraints.add_entry(dof, of_large[j], weight);
  }
}

}  // namespace

void add_hanging_nodes(AffineConstraints<double>& constraints, const Space& space) {
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.kind(cell) == CellKind::absent) continue;
    for (const unsigned f : cell->face_indices())
      if (!cell->at_boundary(f) && cell->neighbor_is_coarser(f) && space.kind(cell->neighbor(f)) == space.kind(cell))
        follow(constraints, space, cell, f, cell->neighbor(f));
  }
}

}  // namespace upbead
