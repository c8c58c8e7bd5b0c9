#include "fem/caisson/caisson.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

#include "fem/caisson/springs.h"
#include "fem/constraints.h"

namespace upbead {

using namespace dealii;

namespace {

std::optional<Caisson> caisson_on_springs(const Space& space) {
  const std::optional<BaseLine> base = lowest_side(space.mesh());
  if (!base) return std::nullopt;
  return Caisson{make_body(space, caisson_name), base->middle, base->width};
}

}  // namespace

std::optional<Caisson> find_caisson(const Space& space) {
  if (is_on_springs(space)) return caisson_on_springs(space);
  double left = std::numeric_limits<double>::infinity(), right = -left, height = 0., length = 0.;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != caisson_name) continue;
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f) || space.mesh().surface_of(cell->neighbor(f)) == caisson_name) continue;
      const CellKind beside = space.kind(cell->neighbor(f));
      if (beside == CellKind::water || beside == CellKind::absent) continue;  // at rest the sea is absent
      const auto face = cell->face(f);
      left = std::min({left, face->vertex(0)[0], face->vertex(1)[0]});
      right = std::max({right, face->vertex(0)[0], face->vertex(1)[0]});
      height += face->measure() * face->center()[1];
      length += face->measure();
    }
  }
  if (length == 0.) return std::nullopt;
  return Caisson{make_body(space, caisson_name), Point<dim>(0.5 * (left + right), height / length), right - left};
}

namespace {

/// Momentum of a caisson that deforms: the integral of density times velocity times a unit motion.
Row deformable_momentum(const Space& space, const Unknowns& unknowns, const Body& body, double density, int motion) {
  std::map<int, double> row;
  const QGauss<dim> quadrature(static_cast<unsigned>(space.degree()) + 1);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != body.region) continue;
    FEValues<dim> fe(space.mapping(), cell->get_fe(), quadrature,
                     update_values | update_quadrature_points | update_JxW_values);
    fe.reinit(typename Triangulation<dim>::cell_iterator(cell));
    const Dofs dofs = dofs_of(cell);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      double sum = 0.;
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
        sum +=
            density * (fe[u_part].value(i, q) * unit_motion(motion, fe.quadrature_point(q), body.centre)) * fe.JxW(q);
      unknowns.add_to(row, dofs[i], sum);
    }
  }
  return to_row(row);
}

}  // namespace

std::array<Row, n_motions> momentum_rows(const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
                                         const Body& caisson, double density) {
  std::array<Row, n_motions> rows;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].region == caisson.region) {
      for (int m = 0; m < n_motions; ++m)
        rows[m] = {{unknowns.coordinate(b, m), m == motion_rotation ? caisson.moment_of_inertia : caisson.mass}};
      return rows;
    }
  for (int m = 0; m < n_motions; ++m) rows[m] = deformable_momentum(space, unknowns, caisson, density, m);
  return rows;
}

namespace {

/// A hanging node counts in each sum with the weights by which it follows other nodes that count there.
void add_hanging(const Space& space, NodalSums& sums) {
  AffineConstraints<double> hanging;
  add_hanging_nodes(hanging, space);
  hanging.close();
  for (const auto& line : hanging.get_lines()) {
    std::map<int, double> parts;
    for (const auto& [dof, weight] : line.entries)
      for (const auto& [sum, part] : sums.of_dof[dof]) parts[sum] += weight * part;
    sums.of_dof[line.index].assign(parts.begin(), parts.end());
  }
}

}  // namespace

NodalSums sums_of_motions(const Space& space, const Caisson& caisson) {
  NodalSums sums;
  sums.n = n_motions;
  sums.of_dof.resize(space.dofs().n_dofs());
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != caisson.body.region) continue;
    const Dofs dofs = dofs_of(cell);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const auto [component, at] = node_of(space, cell, i);
      auto& parts = sums.of_dof[dofs[i]];
      parts.clear();
      for (int m = 0; m < n_motions; ++m)
        if (const double part = unit_motion(m, at, caisson.bottom_centre)[component]; part != 0.)
          parts.emplace_back(m, part);
    }
  }
  add_hanging(space, sums);
  return sums;
}

std::vector<Vector> caisson_motions(const Space& space, const Unknowns& unknowns, const Caisson& caisson) {
  const NodalSums sums = sums_of_motions(space, caisson);
  std::vector<Vector> motions(static_cast<std::size_t>(sums.n), Vector::Zero(unknowns.size()));
  for (unsigned dof = 0; dof < sums.of_dof.size(); ++dof) {
    const Row& expansion = unknowns.expansion(dof);
    // not an unknown of its own: it follows other unknowns
    if (expansion.size() != 1 || expansion.front().second != 1.) continue;
    for (const auto& [motion, part] : sums.of_dof[dof]) motions[motion][expansion.front().first] = part;
  }
  return motions;
}

NodalSums sums_of_nodes(const Space& space, const std::vector<InterfaceNode>& nodes) {
  NodalSums sums;
  sums.of_dof.resize(space.dofs().n_dofs());
  for (const InterfaceNode& node : nodes)
    for (const auto dof : {node.ux, node.uy}) sums.of_dof[dof] = {{sums.n++, 1.}};
  add_hanging(space, sums);
  return sums;
}

NodalReaction::NodalReaction(const Unknowns& unknowns, NodalSums sums) : unknowns_(&unknowns), sums_(std::move(sums)) {
  for (auto* rows : {&M_, &C_, &K_}) rows->resize(static_cast<std::size_t>(sums_.n));
}

bool NodalReaction::has_any(const Dofs& dofs) const {
  return std::any_of(dofs.begin(), dofs.end(), [&](const auto dof) { return !sums_.of_dof[dof].empty(); });
}

double NodalReaction::sum(int sum, const NodalForces& forces) const {
  double total = 0.;
  for (const auto& [dof, force] : forces)
    for (const auto& [k, weight] : sums_.of_dof[dof])
      if (k == sum) total += weight * force;
  return total;
}

Row NodalReaction::nodal_forces(int sum) const {
  Row row;
  for (std::size_t dof = 0; dof < sums_.of_dof.size(); ++dof)
    for (const auto& [k, weight] : sums_.of_dof[dof])
      if (k == sum) row.emplace_back(static_cast<int>(dof), weight);
  return row;
}

void NodalReaction::add(int sum, double stiffness, double damping, const Row& motion) {
  for (const auto& [unknown, weight] : motion) {
    if (stiffness != 0.) K_[static_cast<std::size_t>(sum)][unknown] += stiffness * weight;
    if (damping != 0.) C_[static_cast<std::size_t>(sum)][unknown] += damping * weight;
  }
}

void NodalReaction::add_mass(int sum, const Row& mass) {
  for (const auto& [unknown, weight] : mass) M_[static_cast<std::size_t>(sum)][unknown] += weight;
}

void NodalReaction::add(const CellMatrices& cell, const Dofs& dofs) {
  for (unsigned i = 0; i < dofs.size(); ++i)
    for (const auto& [sum, part] : sums_.of_dof[dofs[i]]) {
      const auto k = static_cast<std::size_t>(sum);
      for (unsigned j = 0; j < dofs.size(); ++j) {
        if (cell.M(i, j) != 0.) unknowns_->add_to(M_[k], dofs[j], part * cell.M(i, j));
        if (cell.C(i, j) != 0.) unknowns_->add_to(C_[k], dofs[j], part * cell.C(i, j));
        if (cell.K(i, j) != 0.) unknowns_->add_to(K_[k], dofs[j], part * cell.K(i, j));
      }
    }
}

CaissonForces::CaissonForces(const Space& space, const Unknowns& unknowns, const Caisson& caisson,
                             const std::vector<InterfaceNode>& bottom_nodes)
    : ground(unknowns, sums_of_motions(space, caisson)), water_front(ground), water_back(ground) {
  if (!bottom_nodes.empty()) bottom.emplace(unknowns, sums_of_nodes(space, bottom_nodes));
}

void CaissonForces::add_ground(const CellMatrices& cell, const Dofs& dofs) {
  ground.add(cell, dofs);
  if (bottom) bottom->add(cell, dofs);
}

void CaissonForces::add(const WetFace& face, const Space& space, const FaceTerms& terms) {
  if (space.mesh().surface_of(face.solid) != caisson_name)
    add_ground(terms.matrices, terms.dofs);
  else
    (outward_normal(face.solid, face.face)[0] < 0. ? water_front : water_back).add(terms.matrices, terms.dofs);
}

StillWater still_water(const Scene& scene, const Caisson& caisson) {
  if (!scene.initial || !scene.initial->harbour_level) return {};
  const double foot = caisson.bottom_centre[1];
  return still_water(*scene.initial->water_level - foot, *scene.initial->harbour_level - foot, caisson.bottom_width,
                     scene.fluid.density * scene.gravity);
}

}  // namespace upbead
