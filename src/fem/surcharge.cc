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

bool is_water(const Scene& scene, const Mesh& mesh, const Triangulation<dim>::cell_iterator& cell) {
  return scene.regions.at(mesh.surface_of(cell)).kind == RegionKind::water;
}

}  // namespace

double covered(const Surcharge& surcharge, const Point<dim>& from, const Point<dim>& to) {
  const auto [one, other] = part(surcharge, from[0], to[0]);
  return (other - one) * std::abs(to[0] - from[0]);
}

std::vector<SurchargePiece> surcharge_pieces(const Scene& scene, const Mesh& mesh) {
  std::vector<SurchargePiece> list;
  if (!scene.initial) return list;
  const auto lies_on = [&](const auto& cell, unsigned f) {
    return cell->at_boundary(f) || (cell->neighbor(f)->is_active() && is_water(scene, mesh, cell->neighbor(f)));
  };
  for (const auto& [name, surcharge] : scene.initial->surcharge)
    for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
      if (is_water(scene, mesh, cell)) continue;
      for (const unsigned f : cell->face_indices()) {
        if (mesh.curve_of(cell->face(f)) != surcharge.boundary || !lies_on(cell, f)) continue;
        const double a = cell->face(f)->vertex(0)[0], b = cell->face(f)->vertex(1)[0];
        const auto [one, other] = part(surcharge, a, b);
        if (!(other > one)) continue;
        const double x = a + one * (b - a), y = a + other * (b - a);
        list.push_back({cell, f, one, other, std::min(x, y), std::max(x, y), surcharge.weight});
      }
    }
  return list;
}

void for_each_surcharge(const Scene& scene, const Space& space,
                        const std::function<void(const Cell&, const std::vector<double>&)>& add) {
  const QGauss<1> gauss(static_cast<unsigned>(space.degree()) + 1);
  for (const SurchargePiece& piece : surcharge_pieces(scene, space.mesh())) {
    const Cell cell(&space.mesh().triangulation, piece.cell->level(), piece.cell->index(), &space.dofs());
    std::vector<Point<1>> points;
    for (unsigned q = 0; q < gauss.size(); ++q)
      points.emplace_back(piece.begin + (piece.end - piece.begin) * gauss.point(q)[0]);
    FEFaceValues<dim> values(space.mapping(), cell->get_fe(), Quadrature<1>(points, gauss.get_weights()),
                             update_values);
    values.reinit(cell, piece.face);
    std::vector<double> force(cell->get_fe().n_dofs_per_cell(), 0.);
    const double weight = piece.weight * (piece.to - piece.from);
    for (unsigned i = 0; i < force.size(); ++i)
      for (unsigned q = 0; q < gauss.size(); ++q) force[i] -= weight * gauss.weight(q) * values[u_part].value(i, q)[1];
    add(cell, force);
  }
}

}  // namespace upbead
