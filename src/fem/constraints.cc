#include "fem/constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "fem/faces.h"
#include "fem/moving_frame.h"

namespace upbead {

using namespace dealii;
using Constraints = AffineConstraints<double>;

namespace {

/// A degree of freedom follows the shape functions of another cell at a point of it.
void follow_at(Constraints& constraints, const Space& space, types::global_dof_index dof, unsigned component,
               const Point<dim>& at, const Cell& other) {
  const Dofs of_other = dofs_of(other);
  const Point<dim> unit = space.mapping().transform_real_to_unit_cell(other, at);
  constraints.add_line(dof);
  for (unsigned j = 0; j < of_other.size(); ++j)
    if (other->get_fe().system_to_component_index(j).first == component)
      if (const double weight = other->get_fe().shape_value(j, unit); std::abs(weight) > 1e-12)
        constraints.add_entry(dof, of_other[j], weight);
}

/// Degrees of freedom on a face of a cell that the cell on the other side lacks: they follow the shape functions of
/// that other cell.
void follow(Constraints& constraints, const Space& space, const Cell& cell, unsigned face, const Cell& other) {
  const auto& fe = cell->get_fe();
  const Dofs of_cell = dofs_of(cell), of_other = dofs_of(other);
  for (unsigned i = 0; i < fe.n_dofs_per_face(face); ++i) {
    const unsigned index = fe.face_to_cell_index(i, face);
    const auto dof = of_cell[index];
    if (constraints.is_constrained(dof) || std::find(of_other.begin(), of_other.end(), dof) != of_other.end()) continue;
    const auto [component, at] = node_of(space, cell, index);
    follow_at(constraints, space, dof, component, at, other);
  }
}

Dofs face_dofs(const Cell& cell, unsigned f) {
  Dofs dofs(cell->get_fe().n_dofs_per_face(f));
  cell->face(f)->get_dof_indices(dofs, cell->active_fe_index());
  return dofs;
}

/// The point of a degree of freedom's node in a cell.
Point<dim> place_of(const Space& space, const Cell& cell, types::global_dof_index dof) {
  const Dofs dofs = dofs_of(cell);
  return node_of(space, cell, static_cast<unsigned>(std::find(dofs.begin(), dofs.end(), dof) - dofs.begin())).at;
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

/// The displacement of the ground's nodes is that of the caisson less slip (x) and opening (y); `first`: index of the
/// first slip.
void add_interface(Constraints& constraints, const std::vector<InterfaceNode>& nodes, types::global_dof_index first) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].has_ground()) continue;
    constraints.add_entry(nodes[i].ux, first + i, -1.);
    constraints.add_entry(nodes[i].uy, first + nodes.size() + i, -1.);
  }
}

/// Prescribed or free motions, with indices after the degrees of freedom of the space: index -> weight.
using Moves = std::map<types::global_dof_index, double>;

/// A condition on a node along a normal: n.u = sum of weight times motion.
struct Hold {
  Tensor<1, dim> normal;
  Moves moves;
};

/// The two degrees of freedom of a node with conditions along normals.
struct HeldNode {
  types::global_dof_index ux, uy;
  std::vector<Hold> holds;
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

/// Adds all entries of a line: of two entries with one index the constraints keep only the first, so indices must
/// differ.
void add_moves(Constraints& constraints, types::global_dof_index dof, const Moves& moves) {
  for (const auto& [index, weight] : moves)
    if (std::abs(weight) > 1e-12) constraints.add_entry(dof, index, weight);
}

void add_scaled(const Moves& moves, double factor, Moves& sum) {
  for (const auto& [index, weight] : moves) sum[index] += factor * weight;
}

double sine_between(const Hold& a, const Hold& b) {
  return a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
}

/// Fixes both components of a node at a corner by the two conditions that differ most: n_a.u = a, n_b.u = b.
void add_corner(Constraints& constraints, const HeldNode& node, const Hold& a, const Hold& b) {
  const double sine = sine_between(a, b);
  const double of_a[]{b.normal[1] / sine, -b.normal[0] / sine}, of_b[]{-a.normal[1] / sine, a.normal[0] / sine};
  const types::global_dof_index dofs[]{node.ux, node.uy};
  for (unsigned d = 0; d < dim; ++d) {
    if (constraints.is_constrained(dofs[d])) continue;
    Moves moves;
    add_scaled(a.moves, of_a[d], moves);
    add_scaled(b.moves, of_b[d], moves);
    constraints.add_line(dofs[d]);
    add_moves(constraints, dofs[d], moves);
  }
}

/// One relation between u_x and u_y of a node, with the mean of its normals.
void add_side(Constraints& constraints, const HeldNode& node) {
  Tensor<1, dim> n;
  for (const Hold& hold : node.holds) n += hold.normal;
  const bool x_leads = std::abs(n[0]) >= std::abs(n[1]);  // the larger component of the normal is eliminated
  const auto slave = x_leads ? node.ux : node.uy, master = x_leads ? node.uy : node.ux;
  const double lead = x_leads ? n[0] : n[1], ratio = (x_leads ? -n[1] : -n[0]) / lead;
  if (constraints.is_constrained(slave)) return;
  Moves moves;
  for (const Hold& hold : node.holds) add_scaled(hold.moves, 1. / lead, moves);
  constraints.add_line(slave);
  add_moves(constraints, slave, moves);
  if (std::abs(ratio) > 1e-12 && !constraints.is_constrained(master)) constraints.add_entry(slave, master, ratio);
}

/// Prescribes the motion along the normals: by one relation between u_x and u_y on a straight or gently curved side,
/// for both at a corner of more than about 6 degrees. A node of a rigid body follows the body.
void add_held(Constraints& constraints, const HeldNode& node) {
  constexpr double sine_of_corner = 0.1;
  const Hold& first = node.holds.front();
  const auto other = std::max_element(node.holds.begin(), node.holds.end(), [&](const Hold& a, const Hold& b) {
    return std::abs(sine_between(first, a)) < std::abs(sine_between(first, b));
  });
  if (std::abs(sine_between(first, *other)) > sine_of_corner)
    add_corner(constraints, node, first, *other);
  else
    add_side(constraints, node);
}

/// The motions of a curve, at a point of it, along the unit vector `along`.
Moves moves_at(const Scene& scene, const SceneMotions& motions, const std::string& curve, const Point<dim>& at,
               const Tensor<1, dim>& along) {
  Moves moves;
  for (std::size_t l = 0; l < motions.loads.size(); ++l) {
    const Load& load = scene.loads.at(motions.loads[l]);
    if (!is_motion(load.kind) || load.boundary != curve) continue;
    const double part = load.direction[0] * along[0] + load.direction[1] * along[1];
    moves[motions.first_load + l] = part * intensity(load, at[0], at[1]);
  }
  for (std::size_t p = 0; p < motions.plates.size(); ++p)
    if (motions.plates[p] == curve) moves[motions.first_plate + p] = 1.;
  return moves;
}

/// Nodes of fixed sides. Sides that a load moves come before sides at rest, as a node at a corner belongs to both.
void add_fixed(Constraints& constraints, const Space& space, const Scene& scene, const SceneMotions& motions) {
  for (const bool moved : {true, false})
    for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
      if (scene.boundaries.at(curve).displacement != DisplacementCondition::fixed) return;
      const auto& fe = cell->get_fe();
      const Dofs dofs = face_dofs(cell, f);
      for (unsigned i = 0; i < dofs.size(); ++i) {
        const unsigned component = fe.face_system_to_component_index(i, f).first;
        if (component >= dim || constraints.is_constrained(dofs[i])) continue;
        Tensor<1, dim> axis;
        axis[component] = 1.;
        const auto at = node_of(space, cell, fe.face_to_cell_index(i, f)).at;
        const Moves moves = moves_at(scene, motions, curve, at, axis);
        if (moves.empty() == moved) continue;
        constraints.add_line(dofs[i]);
        add_moves(constraints, dofs[i], moves);
      }
    });
}

/// The direction along which a side prescribes the motion of its nodes; zero where there is none.
Tensor<1, dim> held_along(DisplacementCondition condition, LevelSides level, const Cell& cell, unsigned f) {
  using D = DisplacementCondition;
  if (condition == D::roller || condition == D::plate) return outward_normal(cell, f);
  Tensor<1, dim> n;
  if (condition == D::level && level != LevelSides::move_alike) n[level == LevelSides::hold_vertically ? 1 : 0] = 1.;
  return n;
}

/// A face of a level side.
struct SideFace {
  Cell cell;
  unsigned number;
  double low() const { return std::min(vertex(0), vertex(1)); }
  double high() const { return std::max(vertex(0), vertex(1)); }
  double vertex(unsigned v) const { return cell->face(number)->vertex(v)[1]; }
};

/// u of each node of the landward level side is that of the seaward one at its height (boundary_check.cc sees to it
/// that the sides are alike).
void add_moving_alike(Constraints& constraints, const Space& space, const Scene& scene) {
  std::vector<SideFace> faces;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    if (scene.boundaries.at(curve).displacement != DisplacementCondition::level || !space.has_matrices(cell)) return;
    faces.push_back({cell, f});
    left = std::min(left, cell->face(f)->center()[0]);
    right = std::max(right, cell->face(f)->center()[0]);
  });
  const auto landward = [&](const SideFace& face) {
    return face.cell->face(face.number)->center()[0] > 0.5 * (left + right);
  };
  const auto seaward = std::partition(faces.begin(), faces.end(), landward);
  if (seaward == faces.end()) return;
  std::sort(seaward, faces.end(), [](const SideFace& a, const SideFace& b) { return a.low() < b.low(); });
  for (auto face = faces.begin(); face != seaward; ++face)
    for (const auto& [index, node] : nodes_on_face(face->cell, face->number))
      for (unsigned d = 0; d < dim; ++d) {
        if (constraints.is_constrained(node[d])) continue;
        const double y = place_of(space, face->cell, node[d])[1];
        auto other = seaward;
        while (other + 1 != faces.end() && y > other->high()) ++other;
        follow_at(constraints, space, node[d], d, {left, std::clamp(y, other->low(), other->high())}, other->cell);
      }
}

void add_supports(Constraints& constraints, const Space& space, const Scene& scene, const SceneMotions& motions) {
  add_fixed(constraints, space, scene, motions);
  const LevelSides level = level_sides(scene);
  std::map<types::global_dof_index, HeldNode> held;
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    const Tensor<1, dim> n = held_along(scene.boundaries.at(curve).displacement, level, cell, f);
    if (n.norm() == 0.) return;
    for (const auto& [index, node] : nodes_on_face(cell, f)) {
      HeldNode& at = held[node[0]];
      at.ux = node[0];
      at.uy = node[1];
      at.holds.push_back({n, moves_at(scene, motions, curve, place_of(space, cell, node[0]), n)});
    }
  });
  for (const auto& [key, node] : held) add_held(constraints, node);
  if (level == LevelSides::move_alike) add_moving_alike(constraints, space, scene);
}

/// phi is continuous between free water and pores, but has one degree less in pores. So at nodes between the vertices
/// the water's phi follows the soil's shape functions. (Both sides have the same level of refinement: see
/// mesh/refine.h.)
void add_wet_pores(Constraints& constraints, const Space& space) {
  for_each_wet_face(space, [&](const WetFace& face) {
    if (space.has_pores(face.solid)) follow(constraints, space, face.water, face.water_face, face.solid);
  });
}

/// Open levels of free water: p = 0 at their nodes, or the pressure of loads there.
void add_water_levels(Constraints& constraints, const Space& space, const Scene& scene, const SceneMotions& motions) {
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    if (space.kind(cell) != CellKind::water) return;
    if (scene.boundaries.at(curve).pressure != PressureCondition::open) return;
    const auto dofs = face_dofs(cell, f);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (constraints.is_constrained(dofs[i])) continue;
      constraints.add_line(dofs[i]);
      const auto at = node_of(space, cell, cell->get_fe().face_to_cell_index(i, f)).at;
      for (std::size_t l = 0; l < motions.loads.size(); ++l)
        if (const Load& load = scene.loads.at(motions.loads[l]); !is_motion(load.kind) && load.boundary == curve)
          constraints.add_entry(dofs[i], motions.first_load + l, intensity(load, at[0], at[1]));
    }
  });
}

/// Curves that a plate lies on.
std::vector<std::string> plates(const Space& space, const Scene& scene) {
  std::set<std::string> found;
  for_each_outer_face(space, [&](const Cell& cell, unsigned, const std::string& curve) {
    if (scene.boundaries.at(curve).displacement == DisplacementCondition::plate && space.kind(cell) != CellKind::water)
      found.insert(curve);
  });
  return {found.begin(), found.end()};
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

std::vector<std::string> prescribing_loads(const Space& space, const Scene& scene) {
  std::set<std::string> found;
  for_each_outer_face(space, [&](const Cell& cell, unsigned, const std::string& curve) {
    const Boundary& side = scene.boundaries.at(curve);
    const bool open = side.pressure == PressureCondition::open && space.has_pressure(cell);
    const bool moves = side.displacement != DisplacementCondition::absorbing;
    for (const auto& [name, load] : scene.loads)
      if (load.boundary == curve && load.factor != 0. &&
          ((load.kind == LoadKind::pressure && open) || (is_motion(load.kind) && moves)))
        found.insert(name);
  });
  return {found.begin(), found.end()};
}

SceneMotions scene_motions(const Space& space, const Scene& scene, std::size_t n_bodies) {
  SceneMotions motions{plates(space, scene), prescribing_loads(space, scene), 0, 0};
  motions.first_plate = space.dofs().n_dofs() + n_motions * n_bodies;
  motions.first_load = motions.first_plate + motions.plates.size();
  return motions;
}

Constraints make_constraints(const Space& space, const Scene& scene, const std::vector<Body>& bodies,
                             const SceneMotions& motions, const std::vector<InterfaceNode>& interface) {
  Constraints constraints;
  add_rigid(constraints, space, bodies);
  add_interface(constraints, interface, motions.first_load + motions.loads.size());
  add_supports(constraints, space, scene, motions);
  add_wet_pores(constraints, space);
  add_hanging_nodes(constraints, space);
  add_water_levels(constraints, space, scene, motions);
  constraints.close();
  return constraints;
}

}  // namespace upbead
