#include "fem/caisson/bottom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "fem/caisson/springs.h"
#include "fem/unknowns.h"
#include "system/interface.h"

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
    const auto [component, at] = node_of(space, cell, index);
    if (component < dim) visit(index, component, at);
  }
}

namespace {

/// The middle of a base on springs stands for all of it.
std::vector<InterfaceNode> node_on_springs(const Mesh& mesh) {
  const std::optional<BaseLine> base = lowest_side(mesh);
  if (!base) return {};
  return {{numbers::invalid_dof_index, numbers::invalid_dof_index, base->middle[0], base->width}};
}

}  // namespace

std::vector<InterfaceNode> interface_nodes(const Space& space) {
  if (is_on_springs(space)) return node_on_springs(space.mesh());
  std::map<types::global_dof_index, InterfaceNode> by_uy;
  for_each_bottom_face(space, [&](const Cell& cell, unsigned f) {
    const Dofs dofs = dofs_of(cell);
    std::map<std::array<double, dim>, InterfaceNode> by_position;
    const FaceValues fe(space, cell, f);
    for_each_displacement(space, cell, f, [&](unsigned index, unsigned component, const Point<dim>& at) {
      InterfaceNode& node = by_position[{at[0], at[1]}];
      node.position = at[0];
      (component == 0 ? node.ux : node.uy) = dofs[index];
      for (unsigned q = 0; component == 0 && q < fe.n_quadrature_points; ++q)
        node.length += fe[u_part].value(index, q)[0] * fe.JxW(q);
    });
    for (auto& [position, node] : by_position) {
      node.length += by_uy[node.uy].length;
      by_uy[node.uy] = node;
    }
  });
  std::vector<InterfaceNode> nodes;
  for (const auto& entry : by_uy) nodes.push_back(entry.second);
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.position < b.position; });
  return nodes;
}

bool bottom_is_level(const Mesh& mesh) {
  constexpr double slope = 1e-6;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, length = 0.;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (mesh.surface_of(cell) != caisson_name) continue;
    for (const unsigned f : cell->face_indices()) {
      const auto face = cell->face(f);
      if (cell->at_boundary(f) || mesh.surface_of(cell->neighbor(f)) == caisson_name) continue;
      if (face->center()[1] > cell->center()[1] ||
          std::abs(face->vertex(1)[0] - face->vertex(0)[0]) < face->measure() / 2)
        continue;  // sides of the caisson
      for (unsigned v = 0; v < 2; ++v) lowest = std::min(lowest, face->vertex(v)[1]);
      for (unsigned v = 0; v < 2; ++v) highest = std::max(highest, face->vertex(v)[1]);
      length += face->measure();
    }
  }
  return highest - lowest <= slope * length;
}

std::vector<Reading> interface_readings(const Unknowns& unknowns, const std::vector<InterfaceNode>& nodes) {
  const int n = static_cast<int>(nodes.size());
  double width = 0.;
  for (const InterfaceNode& node : nodes) width += node.length;
  Row slip;
  for (int i = 0; i < n; ++i) slip.emplace_back(unknowns.opening(i) - n, nodes[i].length / width);
  return {position_reading({interface_group, "slip"}, "m",
                           "slip of the caisson over its ground, mean over the bottom, landward", slip),
          position_reading({interface_group, "opening_seaward"}, "m",
                           "height of the bottom's seaward end above the ground", {{unknowns.opening(0), 1.}}),
          position_reading({interface_group, "opening_landward"}, "m",
                           "height of the bottom's landward end above the ground", {{unknowns.opening(n - 1), 1.}})};
}

void for_each_gap_term(const Space& space, const Unknowns& unknowns, const std::vector<InterfaceNode>& nodes,
                       const std::function<void(const FaceTerms&)>& visit) {
  std::map<types::global_dof_index, int> opening;  // index of the opening, by uy
  for (std::size_t i = 0; i < nodes.size(); ++i) opening[nodes[i].uy] = unknowns.opening(static_cast<int>(i));
  FaceTerms terms;
  for_each_bottom_face(space, [&](const Cell& cell, unsigned f) {
    if (!space.has_pores(cell)) return;
    std::vector<unsigned> shape;
    std::vector<int> unknown;
    const Dofs dofs = dofs_of(cell);
    for_each_displacement(space, cell, f, [&](unsigned index, unsigned component, const Point<dim>&) {
      if (component != 1) return;
      shape.push_back(index);
      unknown.push_back(opening.at(dofs[index]));
    });
    terms.reinit({cell}, unknown);
    const FaceValues fe(space, cell, f);
    for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
      for (unsigned i = 0; i < shape.size(); ++i)
        for (unsigned j = 0; j < fe.dofs_per_cell; ++j) {
          const double part = fe[u_part].value(shape[i], q)[1] * fe[phi_part].value(j, q) * fe.JxW(q);
          terms.matrices.C(fe.dofs_per_cell + i, j) -= part;
          terms.matrices.C(j, fe.dofs_per_cell + i) -= part;
        }
    visit(terms);
  });
}

}  // namespace upbead
