#include "output/field_patches.h"

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <stdexcept>

namespace upbead {

using namespace dealii;

namespace {

constexpr int space = 3;                    ///< VTK has no plane points
constexpr unsigned char quadrilateral = 9;  ///< VTK_QUAD
const char* const region_field = "region";

/// The lattice of a patch: its points along a side, and their places in arrays, x first.
struct Lattice {
  explicit Lattice(const DataOutBase::Patch<dim>& patch) : n(static_cast<int>(patch.n_subdivisions) + 1) {
    if (patch.points_are_available) throw std::logic_error("a patch with curved sides");
  }

  int n_points() const { return n * n; }
  int n_cells() const { return (n - 1) * (n - 1); }

  int n;
};

void add_points(const DataOutBase::Patch<dim>& patch, const Lattice& lattice, std::vector<double>& points) {
  for (int j = 0; j < lattice.n; ++j)
    for (int i = 0; i < lattice.n; ++i) {
      const Point<dim> unit(static_cast<double>(i) / (lattice.n - 1), static_cast<double>(j) / (lattice.n - 1));
      Point<dim> place;
      for (const unsigned v : GeometryInfo<dim>::vertex_indices())
        place += GeometryInfo<dim>::d_linear_shape_function(unit, v) * patch.vertices[v];
      for (unsigned d = 0; d < space; ++d) points.push_back(d < dim ? place[d] : 0.);
    }
}

void add_cells(int first, const Lattice& lattice, std::vector<int>& connectivity) {
  for (int j = 0; j + 1 < lattice.n; ++j)
    for (int i = 0; i + 1 < lattice.n; ++i) {
      const int corner = first + j * lattice.n + i;
      for (const int point : {corner, corner + 1, corner + lattice.n + 1, corner + lattice.n})
        connectivity.push_back(point);
    }
}

}  // namespace

void FieldPatches::add_regions(const Mesh& mesh) {
  names_ = mesh.surfaces;
  regions_.reinit(mesh.triangulation.n_active_cells());
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    regions_[cell->active_cell_index()] = cell->material_id();
  add_data_vector(regions_, region_field, DataOut<dim>::type_cell_data);
}

std::size_t FieldPatches::region_row() const {
  const std::vector<std::string> names = get_dataset_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), region_field) - names.begin());
}

VtuGrid FieldPatches::grid() const {
  constexpr int corners = GeometryInfo<dim>::vertices_per_cell;
  std::vector<double> points;  // in double precision: coordinates of a survey are large beside cells
  std::vector<int> connectivity, offsets, regions;
  const auto row = static_cast<unsigned>(region_row());
  int n_points = 0, n_cells = 0;
  for (const DataOutBase::Patch<dim>& patch : get_patches()) {
    const Lattice lattice(patch);
    add_points(patch, lattice, points);
    add_cells(n_points, lattice, connectivity);
    n_points += lattice.n_points();
    n_cells += lattice.n_cells();
    if (!names_.empty()) regions.resize(static_cast<std::size_t>(n_cells), static_cast<int>(patch.data(row, 0)));
  }
  for (int cell = 1; cell <= n_cells; ++cell) offsets.push_back(corners * cell);
  const std::vector<unsigned char> types(static_cast<std::size_t>(n_cells), quadrilateral);
  return {static_cast<std::size_t>(n_points),
          static_cast<std::size_t>(n_cells),
          vtu_array("points", space, points, Packing::of_grid),
          vtu_array("connectivity", 1, connectivity, Packing::of_grid),
          vtu_array("offsets", 1, offsets, Packing::of_grid),
          vtu_array("types", 1, types, Packing::of_grid),
          names_.empty() ? VtuArray{} : vtu_array(region_field, 1, regions, Packing::of_grid),
          names_};
}

VtuArray FieldPatches::array(const std::string& name, unsigned first, unsigned last, int components) const {
  const auto& patches = get_patches();
  std::vector<float> values;
  if (!patches.empty()) values.reserve(patches.size() * patches.front().data.n_cols() * components);
  for (const DataOutBase::Patch<dim>& patch : patches)
    for (unsigned point = 0; point < patch.data.n_cols(); ++point)
      for (int c = 0; c < components; ++c) {
        const unsigned row = first + static_cast<unsigned>(c);
        values.push_back(row <= last ? patch.data(row, point) : 0.F);
      }
  return vtu_array(name, components, values, Packing::of_fields);
}

std::vector<VtuArray> FieldPatches::arrays() const {
  const std::vector<std::string> names = get_dataset_names();
  std::vector<VtuArray> list;
  std::vector<bool> taken(names.size(), false);
  if (const std::size_t row = region_row(); row < taken.size()) taken[row] = true;
  for (const auto& [first, last, name, interpretation] : get_nonscalar_data_ranges()) {
    list.push_back(array(name, first, last, space));
    for (unsigned i = first; i <= last; ++i) taken[i] = true;
  }
  for (unsigned i = 0; i < names.size(); ++i)
    if (!taken[i]) list.push_back(array(names[i], i, i, 1));
  return list;
}

}  // namespace upbead
