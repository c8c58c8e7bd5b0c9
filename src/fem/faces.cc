#include "fem/faces.h"

#include <deal.II/base/quadrature_lib.h>

namespace upbead {

using namespace dealii;

void for_each_outer_face(const Space& space,
                         const std::function<void(const Cell&, unsigned, const std::string&)>& visit) {
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (cell->at_boundary(f) && space.kind(cell) != CellKind::absent)
        visit(cell, f, space.mesh().curve_of(cell->face(f)));
}

Tensor<1, dim> outward_normal(const Cell& cell, unsigned face) {
  const Tensor<1, dim> along = cell->face(face)->vertex(1) - cell->face(face)->vertex(0);
  Tensor<1, dim> normal;
  normal[0] = along[1] / along.norm();
  normal[1] = -along[0] / along.norm();
  return normal * (cell->face(face)->center() - cell->center()) < 0. ? -normal : normal;
}

void for_each_wet_face(const Space& space, const std::function<void(const WetFace&)>& visit) {
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.kind(cell) == CellKind::water || space.kind(cell) == CellKind::absent) continue;
    for (const unsigned f : cell->face_indices())
      if (!cell->at_boundary(f) && cell->neighbor(f)->is_active() && space.kind(cell->neighbor(f)) == CellKind::water)
        visit({cell, f, cell->neighbor(f), cell->neighbor_of_neighbor(f)});
  }
}

void FaceTerms::reinit(const std::vector<Cell>& cells, const std::vector<int>& prescribed_unknowns) {
  cell = cells.back()->active_cell_index();
  of_caisson = false;
  dofs.clear();
  for (const Cell& each : cells) {
    const Dofs of_cell = dofs_of(each);
    dofs.insert(dofs.end(), of_cell.begin(), of_cell.end());
  }
  prescribed = prescribed_unknowns;
  matrices.reinit(static_cast<unsigned>(dofs.size() + prescribed.size()));
}

FaceValues::FaceValues(const Space& space, const Cell& cell, unsigned face)
    : FEFaceValues<dim>(
          space.mapping(), cell->get_fe(), QGauss<dim - 1>(static_cast<unsigned>(space.degree()) + 1),
          update_values | update_gradients | update_normal_vectors | update_quadrature_points | update_JxW_values) {
  reinit(cell, face);
}

}  // namespace upbead
