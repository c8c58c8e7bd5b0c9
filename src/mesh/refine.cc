#include "mesh/refine.h"

namespace upbead {

namespace {

/// Marks for splitting the neighbours of marked cells across the limits of surfaces; returns whether any was new.
bool choose_across_surfaces(Mesh& mesh) {
  bool changed = false;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (!cell->refine_flag_set()) continue;
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f)) continue;
      const auto neighbour = cell->neighbor(f);
      if (!neighbour->is_active() || neighbour->refine_flag_set()) continue;
      if (neighbour->material_id() == cell->material_id()) continue;
      neighbour->set_refine_flag();
      changed = true;
    }
  }
  return changed;
}

std::unique_ptr<Mesh> copy(const Mesh& mesh) {
  auto other = std::make_unique<Mesh>();
  other->triangulation.copy_triangulation(mesh.triangulation);
  other->surfaces = mesh.surfaces;
  other->curves = mesh.curves;
  other->n_divided_triangles = mesh.n_divided_triangles;
  other->n_high_order = mesh.n_high_order;
  other->most_bent = mesh.most_bent;
  return other;
}

}  // namespace

std::unique_ptr<Mesh> refined(const Mesh& mesh, const std::vector<bool>& chosen) {
  auto finer = copy(mesh);
  for (const auto& cell : finer->triangulation.active_cell_iterators())
    if (chosen[cell->active_cell_index()]) cell->set_refine_flag();
  do {
    finer->triangulation.prepare_coarsening_and_refinement();  // at most one level of difference between neighbours
  } while (choose_across_surfaces(*finer));
  finer->triangulation.execute_coarsening_and_refinement();
  return finer;
}

std::unique_ptr<Mesh> halved(const Mesh& mesh) {
  auto finer = copy(mesh);
  finer->triangulation.refine_global(1);
  return finer;
}

}  // namespace upbead
