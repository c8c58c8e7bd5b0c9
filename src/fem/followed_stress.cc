#include "fem/followed_stress.h"

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <utility>

#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// What each unknown makes of the strain at a point of a cell.
std::vector<std::pair<int, PlaneStrain>> strain_at(const Space& space, const Unknowns& unknowns, const Cell& cell,
                                                   const dealii::Point<dim>& unit) {
  FEValues<dim> values(space.mapping(), cell->get_fe(), Quadrature<dim>(unit), update_gradients);
  values.reinit(Triangulation<dim>::cell_iterator(cell));
  const Dofs dofs = dofs_of(cell);
  std::vector<std::pair<int, PlaneStrain>> list;
  for (unsigned i = 0; i < dofs.size(); ++i) {
    const PlaneStrain of = strain_of(values, i, 0);
    for (const auto& [unknown, weight] : unknowns.expansion(dofs[i]))
      list.emplace_back(unknown, PlaneStrain{weight * of.xx, weight * of.yy, weight * of.xy});
  }
  return list;
}

Eigen::Index number_of(const std::vector<Reading>& readings, const ReadingName& name) {
  const auto found = std::find_if(readings.begin(), readings.end(),
                                  [&](const Reading& reading) { return reading.name.text() == name.text(); });
  return found - readings.begin();
}

}  // namespace

FollowedStress::FollowedStress(const Space& space, const Unknowns& unknowns, const std::vector<Reading>& readings,
                               const PointsOfCells& points, const std::vector<FollowedReading>& points_read) {
  for (const FollowedReading& at : points_read) {
    std::unique_ptr<SoilPoint> soil = points(at.cell->active_cell_index());
    if (!soil) continue;
    Follower follower{std::move(soil), space.material(at.cell), strain_at(space, unknowns, at.cell, at.unit), {}};
    for (const auto& [name, component] : at.components)
      follower.readings.emplace_back(number_of(readings, name), component);
    followers_.push_back(std::move(follower));
  }
}

void FollowedStress::commit(const Vector& x, Vector& added) {
  for (Follower& follower : followers_) {
    PlaneStrain e;
    for (const auto& [unknown, of] : follower.strain)
      e = {e.xx + x[unknown] * of.xx, e.yy + x[unknown] * of.yy, e.xy + x[unknown] * of.xy};
    follower.soil->commit(e);
    const PlaneStress borne = follower.soil->borne(), elastic = follower.elastic.stress(e);
    for (const auto& [reading, component] : follower.readings) added[reading] += borne.*component - elastic.*component;
  }
}

}  // namespace upbead
