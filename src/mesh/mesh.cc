#include "upbead/mesh/mesh.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

#include "mesh_report.h"
#include "raw_mesh.h"

namespace upbead {

namespace {

std::vector<dealii::CellData<dim>> cells_of(const RawMesh& raw) {
  std::vector<dealii::CellData<dim>> cells;
  for (const RawMesh::Cell& from : raw.cells) {
    dealii::CellData<dim> cell;
    const auto& v = from.vertices;
    cell.vertices = {v[0], v[1], v[3], v[2]};  // deal.II orders vertices by rows, not around the cell
    cell.material_id = static_cast<dealii::types::material_id>(from.surface);
    cells.push_back(cell);
  }
  // Neighbours must agree on the direction of their common edge; otherwise elements of degree 3 and more do not match
  // there.
  dealii::GridTools::consistently_order_cells(cells);
  return cells;
}

/// The edges of cells that lie on named curves.
dealii::SubCellData edges_of(const RawMesh& raw) {
  std::map<std::pair<unsigned int, unsigned int>, int> curve_at;
  for (const RawMesh::Edge& edge : raw.edges) curve_at[std::minmax(edge.vertices[0], edge.vertices[1])] = edge.curve;
  dealii::SubCellData edges;
  const std::vector<Side> sides = sorted_sides(raw);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && same_edge(sides[i], sides[i - 1])) continue;
    const auto curve = curve_at.find({sides[i].first, sides[i].second});
    if (curve == curve_at.end()) continue;
    const bool interior = i + 1 < sides.size() && same_edge(sides[i], sides[i + 1]);
    dealii::CellData<1> edge;
    edge.vertices = {sides[i].first, sides[i].second};
    edge.boundary_id = interior ? dealii::numbers::internal_face_boundary_id : 0;
    edge.manifold_id = static_cast<dealii::types::manifold_id>(curve->second);
    edges.boundary_lines.push_back(edge);
  }
  return edges;
}

std::unique_ptr<Mesh> built(const RawMesh& raw) {
  auto mesh = std::make_unique<Mesh>();
  mesh->surfaces = raw.surfaces;
  mesh->curves = raw.curves;
  mesh->n_divided_triangles = raw.n_divided;
  mesh->n_high_order = raw.n_high_order;
  mesh->most_bent = raw.most_bent;
  mesh->triangulation.create_triangulation(raw.vertices, cells_of(raw), edges_of(raw));
  for (unsigned int curve = 0; curve < raw.curves.size(); ++curve)
    mesh->triangulation.set_manifold(curve, dealii::FlatManifold<dim>());
  return mesh;
}

}  // namespace

std::unique_ptr<Mesh> read_mesh(const MeshRequest& request) {
  MeshReport report(request);
  if (request.refine < 0) report.add("it cannot be refined a negative number of times", "set refine to 0 or more");
  RawMesh raw = read_raw_mesh(request, report);
  turn_clockwise_cells(raw);
  check_mesh(raw, report);
  report.throw_if_any();
  std::unique_ptr<Mesh> mesh = built(raw);
  mesh->triangulation.refine_global(request.refine);
  return mesh;
}

double area_of(const dealii::Triangulation<dim>::cell_iterator& cell) {
  const auto a = cell->vertex(3) - cell->vertex(0), b = cell->vertex(2) - cell->vertex(1);
  return 0.5 * std::abs(a[0] * b[1] - a[1] * b[0]);
}

const std::string& Mesh::surface_of(const dealii::Triangulation<dim>::cell_iterator& cell) const {
  return surfaces.at(cell->material_id());
}

const std::string& Mesh::curve_of(const dealii::Triangulation<dim>::face_iterator& face) const {
  static const std::string none;
  const auto id = face->manifold_id();
  return id == dealii::numbers::flat_manifold_id ? none : curves.at(id);
}

}  // namespace upbead
