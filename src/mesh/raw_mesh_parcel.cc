#include "raw_mesh_parcel.h"

#include <algorithm>

namespace upbead {

namespace {

/// Whether all indices are of something that is there.
bool fits(const RawMesh& mesh) {
  const auto vertices_fit = [n = mesh.vertices.size()](const auto& part) {
    return std::all_of(part.vertices.begin(), part.vertices.end(), [n](unsigned int v) { return v < n; });
  };
  const auto is_index = [](int i, int least, std::size_t n) { return i >= least && i < static_cast<int>(n); };
  return std::all_of(mesh.cells.begin(), mesh.cells.end(),
                     [&](const RawMesh::Cell& cell) {
                       return vertices_fit(cell) && is_index(cell.surface, -1, mesh.surfaces.size());
                     }) &&
         std::all_of(mesh.edges.begin(), mesh.edges.end(), [&](const RawMesh::Edge& edge) {
           return vertices_fit(edge) && is_index(edge.curve, 0, mesh.curves.size());
         });
}

}  // namespace

void put(Parcel& parcel, const RawMesh& mesh) {
  std::vector<double> coordinates;
  coordinates.reserve(2 * mesh.vertices.size());
  for (const dealii::Point<2>& point : mesh.vertices) coordinates.insert(coordinates.end(), {point[0], point[1]});
  parcel.put(coordinates);
  parcel.put(mesh.cells);
  parcel.put(mesh.edges);
  parcel.put(mesh.surfaces);
  parcel.put(mesh.curves);
}

std::optional<RawMesh> take_mesh(OpenParcel& parcel) {
  RawMesh mesh;
  const std::vector<double> coordinates = parcel.list<double>();
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
    mesh.vertices.emplace_back(coordinates[i], coordinates[i + 1]);
  mesh.cells = parcel.list<RawMesh::Cell>();
  mesh.edges = parcel.list<RawMesh::Edge>();
  mesh.surfaces = parcel.texts();
  mesh.curves = parcel.texts();
  if (!fits(mesh)) return std::nullopt;
  return mesh;
}

}  // namespace upbead
