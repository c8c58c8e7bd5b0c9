#include "upbead/fem/caisson.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

#include "hanging_nodes.h"

namespace upbead {

using namespace dealii;

std::optional<Caisson> find_caisson(const Space& space) {
  double left = std::numeric_limits<double>::infinity(), right = -left, height = 0., length = 0.;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != caisson_name) continue;
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f) || space.mesh().surface_of(cell->neighbor(f)) == caisson_name) continue;
      if (space.kind(cell->neighbor(f)) == CellKind::water) continue;
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

/// Momentum of a deformable caisson: the integral of density times velocity times a unit motion.
Row deformable_momentum(const Space& space, const Unknowns& unknowns, const Body& body, double density, int motion) {
  std::map<int, double> row;
  std::vector<types::global_dof_index> dofs;
  const QGauss<dim> quadrature(static_cast<unsigned>(space.degree()) + 1);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != body.region) continue;
    FEValues<dim> fe(space.mapping(), cell->get_fe(), quadrature,
                     update_values | update_quadrature_points | update_JxW_values);
    fe.reinit(typename Triangulation<dim>::cell_iterator(cell));
    dofs.resize(fe.dofs_per_cell);
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      double sum = 0.;
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
        sum +=
            density * (fe[u_part].value(i, q) * unit_motion(motion, fe.quadrature_point(q), body.centre)) * fe.JxW(q);
      unknowns.add_to(row, static_cast<unsigned>(dofs[i]), sum);
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

/// Nodes that hang between some of the caisson and some that do not move go part of the way.
void move_hanging_nodes(const Space& space, std::vector<std::array<double, n_motions>>& motions) {
  AffineConstraints<double> hanging;
  add_hanging_nodes(hanging, space);
  hanging.close();
  for (const auto& line : hanging.get_lines())
    for (int m = 0; m < n_motions; ++m) {
      motions[line.index][m] = 0.;
      for (const auto& [dof, weight] : line.entries) motions[line.index][m] += weight * motions[dof][m];
    }
}

}  // namespace

NodalReaction::NodalReaction(const Space& space, const Unknowns& unknowns, const Caisson& caisson)
    : unknowns_(&unknowns), motions_(space.dofs().n_dofs()) {
  std::vector<types::global_dof_index> dofs;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != caisson.body.region) continue;
    const auto& fe = cell->get_fe();
    dofs.resize(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const auto [component, node] = fe.system_to_component_index(i);
      const Point<dim> at =
          space.mapping().transform_unit_to_real_cell(cell, fe.base_element(0).unit_support_point(node));
      for (int m = 0; m < n_motions; ++m) motions_[dofs[i]][m] = unit_motion(m, at, caisson.bottom_centre)[component];
    }
  }
  move_hanging_nodes(space, motions_);
}

bool NodalReaction::has_any(const std::vector<types::global_dof_index>& dofs) const {
  return std::any_of(dofs.begin(), dofs.end(), [&](const auto dof) {
    return std::any_of(motions_[dof].begin(), motions_[dof].end(), [](double motion) { return motion != 0.; });
  });
}

void NodalReaction::add(const CellMatrices& cell, const std::vector<types::global_dof_index>& dofs) {
  for (unsigned i = 0; i < dofs.size(); ++i)
    for (int m = 0; m < n_motions; ++m) {
      const double motion = motions_[dofs[i]][m];
      if (motion == 0.) continue;
      for (unsigned j = 0; j < dofs.size(); ++j) {
        const auto dof = static_cast<unsigned>(dofs[j]);
        if (cell.M(i, j) != 0.) unknowns_->add_to(M_[m], dof, motion * cell.M(i, j));
        if (cell.C(i, j) != 0.) unknowns_->add_to(C_[m], dof, motion * cell.C(i, j));
        if (cell.K(i, j) != 0.) unknowns_->add_to(K_[m], dof, motion * cell.K(i, j));
      }
    }
}

NodalReaction& CaissonForces::of(const WetFace& face, const Space& space) {
  if (space.mesh().surface_of(face.solid) != caisson_name) return ground;
  return outward_normal(face.solid, face.face)[0] < 0. ? water_front : water_back;
}

}  // namespace upbead
