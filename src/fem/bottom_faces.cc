#include "bottom_faces.h"

namespace upbead {

using namespace dealii;

void for_each_bottom_face(const Space& space, const std::function<void(const Cell&, unsigned)>& visit) {
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) == caisson_name) continue;
    if (space.kind(cell) == CellKind::water || space.kind(cell) == CellKind::absent) continue;
    for (const unsigned f : cell->face_indices())
      if (!cell->at_boundary(f) && space.mesh().surface_of(cell->neighbor(f)) == caisson_name) visit(cell, f);
  }
}

void for_each_displacement(const Space& space, const Cell& cell, unsigned f,
                           const std::function<void(unsigned index, unsigned component, const Point<dim>& at)>& visit) {
  const auto& fe = cell->get_fe();
  for (unsigned i = 0; i < fe.n_dofs_per_face(f); ++i) {
    const unsigned index = fe.face_to_cell_index(i, f);
    const auto [component, node] = fe.system_to_component_index(index);
    if (component >= dim) continue;
    const Point<dim> unit = fe.base_element(fe.component_to_base_index(component).first).unit_support_point(node);
    visit(index, component, space.mapping().transform_unit_to_real_cell(cell, unit));
  }
}

}  // namespace upbead
