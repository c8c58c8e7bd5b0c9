#include "mirror.h"

#include <deal.II/grid/grid_tools.h>

#include <utility>

namespace upbead::test {

void mirror(Mesh& mesh) {
  auto& triangulation = mesh.triangulation;
  const unsigned int refinements = triangulation.n_levels() - 1;
  auto [vertices, cells, edges] = dealii::GridTools::get_coarse_mesh_description(triangulation);
  for (auto& vertex : vertices) vertex[0] = -vertex[0];
  for (auto& cell : cells) {
    std::swap(cell.vertices[0], cell.vertices[1]);
    std::swap(cell.vertices[2], cell.vertices[3]);
  }
  dealii::GridTools::consistently_order_cells(cells);
  triangulation.clear();
  triangulation.create_triangulation(vertices, cells, edges);
  for (unsigned int curve = 0; curve < mesh.curves.size(); ++curve)
    triangulation.set_manifold(curve, dealii::FlatManifold<dim>());
  triangulation.refine_global(refinements);
}

}  // namespace upbead::test
