#include "fem/surcharge.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace upbead {

using namespace dealii;

namespace {

/// Shares of the way from a to b between which a surcharge lies; two equal ones where it does not lie there.
std::array<double, 2> part(const Surcharge& surcharge, double a, double b) {
  const double left = std::max(surcharge.from.value_or(-HUGE_VAL), std::min(a, b));
  const double right = std::min(surcharge.to.value_or(HUGE_VAL), std::max(a, b));
  if (!(right > left)) return {0., 0.};
  const double one = (left - a) / (b - a), other = (right - a) / (b - a);
  return {std::min(one, other), std::max(one, other)};
}

bool lies_on(const Space& space, const Cell& cell, unsigned f) {
  if (cell->at_boundary(f)) return true;
  return cell->neighbor(f)->is_active() && space.kind(cell->neighbor(f)) == CellKind::absent;
}

}  // namespace

double covered(const Surcharge& surcharge, const Point<dim>& from, const Point<dim>& to) {
  const auto [one, other] = part(surcharge, from[0], to[0]);
  return (other - one) * std::abs(to[0] - from[0]);
}

void for_each_surcharge(const Scene& scene, const Space& space,
                        const std::function<void(const Cell&, const std::vector<double>&)>& add) {
  if (!scene.initial) return;
  const QGauss<1> gauss(static_cast<unsigned>(space.degree()) + 1);
  for (const auto& [name, surcharge] : scene.initial->surcharge)
    for (const auto& cell : space.dofs().active_cell_iterators()) {
      if (space.kind(cell) == CellKind::absent) continue;
      for (const unsigned f : cell->face_indices()) {
        if (space.mesh().curve_of(cell->face(f)) != surcharge.boundary || !lies_on(space, cell, f)) continue;
        const Point<dim> a = cell->face(f)->vertex(0), b = cell->face(f)->vertex(1);
        const auto [one, other] = part(surcharge, a[0], b[0]);
        if (!(other > one)) continue;
        std::vector<Point<1>> points;
        for (unsigned q = 0; q < gauss.size(); ++q) points.emplace_back(one + (other - one) * gauss.point(q)[0]);
        FEFaceValues<dim> values(space.mapping(), cell->get_fe(), Quadrature<1>(points, gauss.get_weights()),
                                 update_values);
        values.reinit(cell, f);
        std::vector<double> force(cell->get_fe().n_dofs_per_cell(), 0.);
        const double weight = surcharge.weight * covered(surcharge, a, b);
        for (unsigned i = 0; i < force.size(); ++i)
          for (unsigned q = 0; q < gauss.size(); ++q)
            force[i] -= weight * gauss.weight(q) * values[u_part].value(i, q)[1];
        add(cell, force);
      }
    }
}

}  // namespace upbead
