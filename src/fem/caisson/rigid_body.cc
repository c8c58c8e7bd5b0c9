#include "fem/caisson/rigid_body.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <optional>

namespace upbead {

using namespace dealii;

Tensor<1, dim> unit_motion(int motion, const Point<dim>& point, const Point<dim>& centre) {
  Tensor<1, dim> u;
  if (motion == motion_rotation) {
    u[0] = point[1] - centre[1];
    u[1] = -(point[0] - centre[0]);
  } else {
    u[motion] = 1.;
  }
  return u;
}

namespace {

/// Calls visit(point, weight) at the quadrature points of all cells of a region; exact for quadratic functions.
template <typename Visit>
void for_each_point(const Space& space, const std::string& name, const Visit& visit) {
  const FE_Nothing<dim> nothing;
  FEValues<dim> values(space.mapping(), nothing, QGauss<dim>(3), update_quadrature_points | update_JxW_values);
  for (const auto& cell : space.mesh().triangulation.active_cell_iterators()) {
    if (space.mesh().surface_of(cell) != name) continue;
    values.reinit(cell);
    for (unsigned q = 0; q < values.n_quadrature_points; ++q) visit(values.quadrature_point(q), values.JxW(q));
  }
}

const Region& region_of(const Space& space, const std::string& name) {
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (space.mesh().surface_of(cell) == name) return space.region(cell);
  throw std::logic_error("no cell in region " + name);
}

/// Centre and inertia of a body whose parts have densities of their own; what a part has more than the rest counts as a
/// rectangle there, with (b^2 + h^2)/12 about its middle.
void add_parts(const Region& region, double second_moment, Body& body) {
  const double rho = region.density.value_or(0.);
  Tensor<1, dim> first;  // about the middle of the area
  double second = rho * second_moment;
  for (const auto& [name, part] : region.parts) {
    const double more = (part.density - rho) * part.area();
    const double width = part.x[1] - part.x[0], height = part.y[1] - part.y[0];
    const Tensor<1, dim> at = Point<dim>(0.5 * (part.x[0] + part.x[1]), 0.5 * (part.y[0] + part.y[1])) - body.middle;
    first += more * at;
    second += more * (at.norm_square() + (width * width + height * height) / 12.);
  }
  body.centre = body.middle + first / body.mass;
  body.moment_of_inertia = second - first.norm_square() / body.mass;
}

}  // namespace

Body make_body(const Space& space, const std::string& name) {
  const Region& region = region_of(space, name);
  Body body;
  body.region = name;
  Tensor<1, dim> first_moment;  // about a point of the body: far from the origin its area has less digits than places
  std::optional<Point<dim>> origin;
  for_each_point(space, name, [&](const Point<dim>& point, double weight) {
    if (!origin) origin = point;
    body.area += weight;
    first_moment += weight * (point - *origin);
  });
  body.centre = origin.value_or(Point<dim>()) + first_moment / body.area;
  for (unsigned d = 0; d < dim; ++d)  // a symmetric body has its centre at 0, without round-off
    if (std::abs(body.centre[d]) < 1e-12 * std::sqrt(body.area)) body.centre[d] = 0.;
  double second_moment = 0.;  // polar, about the centroid (m4)
  for_each_point(space, name, [&](const Point<dim>& point, double weight) {
    second_moment += weight * (point - body.centre).norm_square();
  });
  body.middle = body.centre;
  body.mass = region.mass_over(body.area);
  body.moment_of_inertia = region.moment_of_inertia.value_or(body.mass / body.area * second_moment);
  if (!region.parts.empty()) add_parts(region, second_moment, body);
  if (region.centre_of_gravity)
    body.centre = Point<dim>((*region.centre_of_gravity)[0], (*region.centre_of_gravity)[1]);
  return body;
}

std::vector<Body> rigid_bodies(const Space& space) {
  std::vector<Body> bodies;
  for (const std::string& name : space.mesh().surfaces)
    if (region_of(space, name).kind == RegionKind::rigid) bodies.push_back(make_body(space, name));
  return bodies;
}

}  // namespace upbead
