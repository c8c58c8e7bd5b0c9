#include "fem/followed_stress.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <utility>

#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// Strain at a point of a cell per unit of each unknown.
std::vector<std::pair<int, PlaneStrain>> strain_at(const Space& space, const Unknowns& unknowns, int n_unknowns,
                                                   const Cell& cell, const dealii::Point<dim>& unit) {
  FEValues<dim> values(space.mapping(), cell->get_fe(), Quadrature<dim>(unit), update_gradients);
  values.reinit(Triangulation<dim>::cell_iterator(cell));
  const Dofs dofs = dofs_of(cell);
  std::vector<std::pair<int, PlaneStrain>> list;
  for (unsigned i = 0; i < dofs.size(); ++i) {
    const PlaneStrain of = strain_of(values, i, 0);
    for (const auto& [unknown, weight] : unknowns.expansion(dofs[i]))
      if (unknown < n_unknowns) list.emplace_back(unknown, PlaneStrain{weight * of.xx, weight * of.yy, weight * of.xy});
  }
  return list;
}

Eigen::Index number_of(const std::vector<Reading>& readings, const ReadingName& name) {
  const auto found = std::find_if(readings.begin(), readings.end(),
                                  [&](const Reading& reading) { return reading.name.text() == name.text(); });
  return found - readings.begin();
}

}  // namespace

FollowedStress::FollowedStress(const Space& space, const Unknowns& unknowns, int n_unknowns,
                               const std::vector<Reading>& readings, const PointsOfCells& points,
                               const std::vector<FollowedReading>& points_read) {
  const QGauss<1> line(static_cast<unsigned>(space.degree()) + 1);
  const FE_DGQArbitraryNodes<dim> between(line);  // polynomials that are 1 at one point of quadrature, 0 at the others
  const std::vector<dealii::Point<dim>> points_of_cell = QGauss<dim>(line.size()).get_points();
  for (const FollowedReading& at : points_read) {
    Follower follower;
    for (unsigned q = 0; q < points_of_cell.size(); ++q) {
      std::unique_ptr<SoilPoint> soil = points(at.cell->active_cell_index(), q);
      if (!soil) continue;
      follower.points.push_back({std::move(soil), between.shape_value(q, at.unit),
                                 strain_at(space, unknowns, n_unknowns, at.cell, points_of_cell[q])});
    }
    if (follower.points.empty()) continue;
    for (const auto& [name, component] : at.components)
      follower.readings.emplace_back(number_of(readings, name), component);
    followers_.push_back(std::move(follower));
  }
}

void FollowedStress::commit(const Vector& x, Vector& added) {
  for (Follower& follower : followers_)
    for (FollowedPoint& point : follower.points) {
      PlaneStrain e;
      for (const auto& [unknown, of] : point.strain)
        e = {e.xx + x[unknown] * of.xx, e.yy + x[unknown] * of.yy, e.xy + x[unknown] * of.xy};
      double dissipated = 0.;
      point.soil->commit(e, dissipated);
      PlaneStress correction;
      point.soil->correct(e, correction);
      for (const auto& [reading, component] : follower.readings) added[reading] -= point.share * correction.*component;
    }
}

void FollowedStress::remember(std::vector<double>& memory) const {
  for (const Follower& follower : followers_)
    for (const FollowedPoint& point : follower.points) point.soil->remember(memory);
}

const double* FollowedStress::recall(const double* memory) {
  for (Follower& follower : followers_)
    for (FollowedPoint& point : follower.points) memory = point.soil->recall(memory);
  return memory;
}

}  // namespace upbead
