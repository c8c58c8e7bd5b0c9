#include "fem/constraints.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/faces.h"

namespace upbead {

using namespace dealii;
using Constraints = AffineConstraints<double>;

namespace {

/// The degrees of freedom on a face of a cell that the cell on its other side does not have follow that one's shape
/// functions.
void follow(Constraints& constraints, const Space& space, const Cell& cell, unsigned face, const Cell& other) {
  const auto& fe = cell->get_fe();
  const Dofs of_cell = dofs_of(cell), of_other = dofs_of(other);
  for (unsigned i = 0; i < fe.n_dofs_per_face(face); ++i) {
    const unsigned index = fe.face_to_cell_index(i, face);
    const auto dof = of_cell[index];
    if (constraints.is_constrained(dof) || std::find(of_other.begin(), of_other.end(), dof) != of_other.end()) continue;
    const auto [component, at] = node_of(space, cell, index);
    const Point<dim> unit = space.mapping().transform_real_to_unit_cell(other, at);
    constraints.add_line(dof);
    for (unsigned j = 0; j < of_other.size(); ++j)
      if (other->get_fe().system_to_component_index(j).first == component)
        if (const double weight = other->get_fe().shape_value(j, unit); std::abs(weight) > 1e-12)
          constraints.add_entry(dof, of_other[j], weight);
  }
}

Dofs face_dofs(const Cell& cell, unsigned f) {
  Dofs dofs(cell->get_fe().n_dofs_per_face(f));
  cell->face(f)->get_dof_indices(dofs, cell->active_fe_index());
  return dofs;
}

void constrain(Constraints& constraints, types::global_dof_index dof) {
  if (!constraints.is_constrained(dof)) constraints.add_line(dof);
}

/// u of every node of a rigid region follows the body's three coordinates.
void add_rigid(Constraints& constraints, const Space& space, const std::vector<Body>& bodies) {
  const types::global_dof_index first = space.dofs().n_dofs();
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (space.mesh().surface_of(cell) != bodies[b].region) continue;
      const Dofs dofs = dofs_of(cell);
      for (unsigned i = 0; i < dofs.size(); ++i) {
        if (constraints.is_constrained(dofs[i])) continue;
        const auto [component, at] = node_of(space, cell, i);
        constraints.add_line(dofs[i]);
        for (int m = 0; m < n_motions; ++m)
          if (const double weight = unit_motion(m, at, bodies[b].centre)[component]; weight != 0.)
            constraints.add_entry(dofs[i], first + n_motions * b + static_cast<unsigned>(m), weight);
      }
    }
}

/// The ground's nodes leave the caisson by slip (x) and opening (y); `first`: index of the first slip.
void add_interface(Constraints& constraints, const std::vector<InterfaceNode>& nodes, types::global_dof_index first) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    constraints.add_entry(nodes[i].ux, first + i, -1.);
    constraints.add_entry(nodes[i].uy, first + nodes.size() + i, -1.);
  }
}

/// A node on rollers: its two degrees of freedom and the normals of the rollers that it touches.
struct RollerNode {
  types::global_dof_index ux, uy;
  std::vector<Tensor<1, dim>> normals;
};

/// The degrees of freedom of u of each node on a face, as pairs.
std::map<unsigned, std::array<types::global_dof_index, 2>> nodes_on_face(const Cell& cell, unsigned f) {
  std::map<unsigned, std::array<types::global_dof_index, 2>> nodes;
  const auto dofs = face_dofs(cell, f);
  for (unsigned i = 0; i < dofs.size(); ++i) {
    const auto [component, node] = cell->get_fe().face_system_to_component_index(i, f);
    if (component < dim) nodes[node][component] = dofs[i];
  }
  return nodes;
}

/// No motion along the normal: one relation between u_x and u_y on a straight or gently curved side (by the mean
/// normal), both fixed at a corner of more than about 6 degrees. A node of a rigid body follows the body.
void add_rollers(Constraints& constraints, const std::map<types::global_dof_index, RollerNode>& rollers) {
  constexpr double sine_of_corner = 0.1;
  for (const auto& [key, node] : rollers) {
    Tensor<1, dim> n;
    bool corner = false;
    for (const auto& normal : node.normals) {
      n += normal;
      const auto& first = node.normals.front();
      corner = corner || std::abs(first[0] * normal[1] - first[1] * normal[0]) > sine_of_corner;
    }
    if (corner) {
      constrain(constraints, node.ux);
      constrain(constraints, node.uy);
      continue;
    }
    const bool x_leads = std::abs(n[0]) >= std::abs(n[1]);  // the larger component of the normal is eliminated
    const auto slave = x_leads ? node.ux : node.uy, master = x_leads ? node.uy : node.ux;
    const double ratio = x_leads ? -n[1] / n[0] : -n[0] / n[1];
    if (constraints.is_constrained(slave)) continue;
    constraints.add_line(slave);
    if (std::abs(ratio) > 1e-12 && !constraints.is_constrained(master)) constraints.add_entry(slave, master, ratio);
  }
}

void add_supports(Constraints& constraints, const Space& space, const Scene& scene) {
  std::map<types::global_dof_index, RollerNode> rollers;
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    const Boundary& boundary = scene.boundaries.at(curve);
    if (boundary.displacement != DisplacementCondition::fixed && boundary.displacement != DisplacementCondition::roller)
      return;
    for (const auto& [index, node] : nodes_on_face(cell, f)) {
      if (boundary.displacement == DisplacementCondition::fixed) {
        constrain(constraints, node[0]);
        constrain(constraints, node[1]);
      } else {
        RollerNode& roller = rollers[node[0]];
        roller.ux = node[0];
        roller.uy = node[1];
        roller.normals.push_back(outward_normal(cell, f));
      }
    }
  });
  add_rollers(constraints, rollers);
}

/// phi is continuous from free water into pores, but of one degree less there: between the vertices, which both share,
/// the water's nodes follow the soil's shape functions. (Both sides are of one level of refinement: see mesh/refine.h.)
void add_wet_pores(Constraints& constraints, const Space& space) {
  for_each_wet_face(space, [&](const WetFace& face) {
    if (space.has_pores(face.solid)) follow(constraints, space, face.water, face.water_face, face.solid);
  });
}

/// Open levels of free water: p = 0, or the pressure of loads there, at their nodes. A load's unknown has the index
/// first_prescribed + its place in `loads`.
void add_water_levels(Constraints& constraints, const Space& space, const Scene& scene,
                      const std::vector<std::string>& loads, types::global_dof_index first_prescribed) {
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    if (space.kind(cell) != CellKind::water) return;
    if (scene.boundaries.at(curve).pressure != PressureCondition::open) return;
    const auto dofs = face_dofs(cell, f);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (constraints.is_constrained(dofs[i])) continue;
      constraints.add_line(dofs[i]);
      const auto at = node_of(space, cell, cell->get_fe().face_to_cell_index(i, f)).at;
      for (std::size_t l = 0; l < loads.size(); ++l)
        if (const Load& load = scene.loads.at(loads[l]); load.boundary == curve)
          constraints.add_entry(dofs[i], first_prescribed + l, intensity(load, at[0], at[1]));
    }
  });
}

}  // namespace

void add_hanging_nodes(Constraints& constraints, const Space& space) {
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.kind(cell) == CellKind::absent) continue;
    for (const unsigned f : cell->face_indices())
      if (!cell->at_boundary(f) && cell->neighbor_is_coarser(f) && space.kind(cell->neighbor(f)) == space.kind(cell))
        follow(constraints, space, cell, f, cell->neighbor(f));
  }
}

std::vector<std::string> pressure_prescribing_loads(const Space& space, const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [name, load] : scene.loads) {
    if (load.kind != LoadKind::pressure || load.factor == 0.) continue;
    bool prescribes = false;
    const std::string& boundary = load.boundary;
    for_each_outer_face(space, [&](const Cell& cell, unsigned, const std::string& curve) {
      const bool open = scene.boundaries.at(curve).pressure == PressureCondition::open;
      prescribes = prescribes || (curve == boundary && open && space.has_pressure(cell));
    });
    if (prescribes) names.push_back(name);
  }
  return names;
}

Constraints make_constraints(const Space& space, const Scene& scene, const std::vector<Body>& bodies,
                             const std::vector<InterfaceNode>& interface) {
  Constraints constraints;
  const std::vector<std::string> pressures = pressure_prescribing_loads(space, scene);
  const types::global_dof_index first_pressure = space.dofs().n_dofs() + n_motions * bodies.size();
  add_rigid(constraints, space, bodies);
  add_interface(constraints, interface, first_pressure + pressures.size());
  add_supports(constraints, space, scene);
  add_wet_pores(constraints, space);
  add_hanging_nodes(constraints, space);
  add_water_levels(constraints, space, scene, pressures, first_pressure);
  constraints.close();
  return constraints;
}

}  // namespace upbead
