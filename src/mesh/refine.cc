#include "upbead/mesh/refine.h"

namespace upbead {

namespace {

/// Chooses the neighbours across surfaces of all cells that are to be split; whether there was any new one.
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

}  // namespace

void refine_cells(Mesh& mesh, const std::vector<bool>& chosen) {
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (chosen[cell->active_cell_index()]) cell->set_refine_flag();
  do {
    mesh.triangulation.prepare_coarsening_and_refinement();  // one level of difference
  } while (choose_across_surfaces(mesh));
  mesh.triangulation.execute_coarsening_and_refinement();
}

std::unique_ptr<Mesh> halved(const Mesh& mesh) {
  auto finer = std::make_unique<Mesh>();
  finer->triangulation.copy_triangulation(mesh.triangulation);
  finer->surfaces = mesh.surfaces;
  finer->curves = mesh.curves;
  finer->triangulation.refine_global(1);
  return finer;
}

}  // namespace upbead
