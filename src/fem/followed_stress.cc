#include "fem/followed_stress.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>

#include <algorithm>
#include <utility>

#include "fem/cell_pack.h"

namespace upbead {

using namespace dealii;

namespace {

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
  for (const FollowedReading& at : points_read) {
    Follower follower;
    std::vector<PointStrain> strains = strains_by_unknown(shapes_of(space, at.cell), unknowns);
    for (unsigned q = 0; q < strains.size(); ++q) {
      std::unique_ptr<SoilPoint> soil = points(at.cell->active_cell_index(), q);
      if (!soil) continue;
      std::map<int, PlaneStrain>& strain = strains[q].strain;
      strain.erase(strain.lower_bound(n_unknowns), strain.end());
      follower.points.push_back({std::move(soil), between.shape_value(q, at.unit), std::move(strain)});
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
