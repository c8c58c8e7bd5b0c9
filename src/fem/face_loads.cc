#include "fem/face_loads.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

#include "fem/faces.h"

namespace upbead {

using namespace dealii;

namespace {

/// Gauss points on a face, split where the load's table of intensities has a corner, so that the integrand is a
/// polynomial between.
Quadrature<1> split_quadrature(const Load& load, const Point<dim>& from, const Point<dim>& to, unsigned n_points) {
  std::vector<double> ends{0., 1.};
  for (const auto& [height, value] : load.shape) {
    const double at = (height - from[1]) / (to[1] - from[1]);
    if (at > 0. && at < 1.) ends.push_back(at);
  }
  std::sort(ends.begin(), ends.end());
  const QGauss<1> gauss(n_points);
  std::vector<Point<1>> points;
  std::vector<double> weights;
  for (std::size_t s = 0; s + 1 < ends.size(); ++s)
    for (unsigned q = 0; q < gauss.size(); ++q) {
      points.emplace_back(ends[s] + (ends[s + 1] - ends[s]) * gauss.point(q)[0]);
      weights.push_back((ends[s + 1] - ends[s]) * gauss.weight(q));
    }
  return Quadrature<1>(points, weights);
}

/// Whether a load acts on a face of its curve: an outer one, or one of a solid under free water.
bool acts_on(const Space& space, const Cell& cell, unsigned f) {
  if (cell->at_boundary(f)) return true;
  if (!cell->neighbor(f)->is_active()) return false;  // smaller cells of its own surface
  return space.kind(cell) != CellKind::water && space.kind(cell->neighbor(f)) == CellKind::water;
}

/// Calls visit(cell, values on the face) for every face on the load's curve that the load acts on.
template <typename Visit>
void for_each_face(const Space& space, const Load& load, UpdateFlags flags, const Visit& visit) {
  const unsigned n_points = static_cast<unsigned>(space.degree()) + 2;
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (space.mesh().curve_of(cell->face(f)) != load.boundary || !acts_on(space, cell, f)) continue;
      const auto quadrature = split_quadrature(load, cell->face(f)->vertex(0), cell->face(f)->vertex(1), n_points);
      FEFaceValues<dim> values(space.mapping(), cell->get_fe(), quadrature,
                               flags | update_quadrature_points | update_JxW_values);
      values.reinit(cell, f);
      visit(cell, values);
    }
}

/// Traction at a point of the curve at f(t) = 1 (Pa): total stress times normal.
Tensor<1, dim> traction(const Load& load, const Point<dim>& at, const Tensor<1, dim>& normal, double scale) {
  if (load.kind == LoadKind::pressure) return -intensity(load, at[1]) * normal;
  Tensor<1, dim> direction;
  for (unsigned d = 0; d < dim; ++d) direction[d] = load.direction[d];
  return scale * intensity(load, at[1]) * direction;
}

/// Integral of the relative intensity along the curve (m).
double total_intensity(const Space& space, const Load& load) {
  double total = 0.;
  for_each_face(space, load, update_default, [&](const Cell&, const FEFaceValues<dim>& values) {
    for (unsigned q = 0; q < values.n_quadrature_points; ++q)
      total += intensity(load, values.quadrature_point(q)[1]) * values.JxW(q);
  });
  return total;
}

}  // namespace

std::map<std::string, NodalForces> curve_forces(const Space& space, const Load& load) {
  std::map<std::string, NodalForces> forces;
  const double scale = load.kind == LoadKind::force ? 1. / total_intensity(space, load) : 1.;
  std::vector<types::global_dof_index> dofs;
  const auto flags = update_values | update_normal_vectors;
  for_each_face(space, load, flags, [&](const Cell& cell, const FEFaceValues<dim>& values) {
    NodalForces& nodal = forces[space.mesh().surface_of(cell)];
    dofs.resize(values.dofs_per_cell);
    cell->get_dof_indices(dofs);
    for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
      const Tensor<1, dim> t = traction(load, values.quadrature_point(q), values.normal_vector(q), scale);
      for (unsigned i = 0; i < dofs.size(); ++i)
        if (const double part = values[u_part].value(i, q) * t * values.JxW(q); part != 0.) nodal[dofs[i]] += part;
    }
  });
  return forces;
}

}  // namespace upbead
