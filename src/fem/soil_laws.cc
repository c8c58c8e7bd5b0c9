#include "fem/soil_laws.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fem/kernels.h"
#include "material/few_elements.h"

namespace upbead {

namespace {

constexpr double degree = boost::math::constants::degree<double>();
/// Number of points of the backbone that the elements of the overlay are found from, and their range of strain, over
/// the reference strain: up to 97 % of the strength of the hyperbola.
constexpr int n_points = 1000;
constexpr double first_strain = 0.001, last_strain = 30.;
/// Least mean stress for the strength, over the mean of the region: strength would vanish at free surfaces.
constexpr double least_stress = 0.1;

PlaneStress at_rest(const EffectiveStress& rest, std::size_t cell, const std::optional<double>& k0) {
  const double vertical = -rest.vertical[cell];
  if (k0) return {*k0 * vertical, vertical, -rest.shear[cell], *k0 * vertical};
  return {-rest.horizontal[cell], vertical, -rest.shear[cell], -rest.out_of_plane[cell]};
}

/// The given K_0, or that of Jaky (1944) with phi', or that of elastic soil without lateral strain.
double earth_pressure_at_rest(const Region& region, const std::optional<double>& given) {
  if (given) return *given;
  if (region.strength) return 1. - std::sin(region.strength->friction_angle * degree);
  return *region.poissons_ratio / (1. - *region.poissons_ratio);
}

ShearCompaction compaction_of(const Densification& d) {
  return {d.C1(), d.C2(), d.threshold};
}

double bulk_modulus(const ElasticLaw& law) {
  return law.lambda + 2. / 3. * law.G;
}

std::unique_ptr<SoilPoint> kept(std::unique_ptr<CompactingPoint> point, unsigned cell, CompactingPoints& list) {
  list.emplace_back(cell, point.get());
  return point;
}

/// Makes the laws of a scene, cell by cell.
class Maker {
 public:
  Maker(const Scene& scene, const Space& space, const EffectiveStress& rest, RestStart start,
        const PointStresses* failing)
      : k0_(k0_of(scene)), rest_(rest), start_(start), failing_(failing) {
    std::map<std::string, std::pair<double, double>> sums;  // sum of stress times area, and of area
    for (const Cell& cell : space.dofs().active_cell_iterators()) {
      auto& [stress, area] = sums[space.mesh().surface_of(cell)];
      stress += area_of(cell) * std::max(rest.mean(cell->active_cell_index(), k0_), 0.);
      area += area_of(cell);
    }
    for (const auto& [name, sum] : sums) floor_[name] = least_stress * sum.first / sum.second;
  }

  PointsOfCells of(const Space& space, const Cell& cell, RestReport& report) const {
    const Region& region = space.region(cell);
    const std::size_t i = cell->active_cell_index();
    report.area += area_of(cell);
    if (region.law == SoilLaw::hysteretic)
      return denser(region, space.material(cell), rest_.mean(i, k0_),
                    hysteretic(space.mesh().surface_of(cell), region, space.material(cell), i, area_of(cell), report));
    const Strength& s = *region.strength;
    const auto law = std::make_shared<const MohrCoulombLaw>(
        space.material(cell), MohrCoulombStrength{s.friction_angle, s.cohesion, s.dilatancy_angle, s.tension});
    if (failing_) return mohr_coulomb(region, law, space.material(cell), failing_->at(i));
    const PlaneStress stress = at_rest(rest_, i, k0_);
    if (law->excess(stress) > 0.) report.beyond += area_of(cell);
    return mohr_coulomb(region, law, space.material(cell), {stress});
  }

  std::shared_ptr<CompactingPoints> compacting() const { return compacting_; }

 private:
  /// Points that compact where the region has densification; else the given points.
  PointsOfCells denser(const Region& region, const ElasticLaw& elastic, double mean,
                       const PointsOfCells& points) const {
    if (!region.densification) return points;
    return [points, mean, bulk = bulk_modulus(elastic), law = compaction_of(*region.densification), list = compacting_](
               unsigned index, unsigned point) {
      return kept(compacting_point(points(index, point), bulk, law, mean), index, *list);
    };
  }

  /// From one stress for each point, or one for all points.
  PointsOfCells mohr_coulomb(const Region& region, const std::shared_ptr<const MohrCoulombLaw>& law,
                             const ElasticLaw& elastic, std::vector<PlaneStress> stresses) const {
    const auto at = [stresses = std::move(stresses)](unsigned point) { return stresses[point % stresses.size()]; };
    if (!region.densification) return [law, at](unsigned, unsigned point) { return soil_point(law, at(point)); };
    return [law, at, bulk = bulk_modulus(elastic), denser = compaction_of(*region.densification), list = compacting_](
               unsigned index, unsigned point) {
      return kept(compacting_point(law, at(point), bulk, denser), index, *list);
    };
  }

  /// The points of the overlay for G = 1: over the reference strain where the strength alone is given, which then is 1.
  static std::vector<BackbonePoint> unit_curve(const Region& region, double strength) {
    const auto hyperbola = [](double gamma) { return 1. / (1. + gamma); };
    if (!region.strain_law) return with_few_elements(1., backbone(1., hyperbola, first_strain, last_strain, n_points));
    const StrainLaw& law = *region.strain_law;
    double from = first_strain * law.reference_strain, to = last_strain * law.reference_strain;
    if (!law.modulus.empty()) {
      from = law.modulus.front()[0];
      to = law.modulus.back()[0];
    }
    const auto points = concave(backbone(
        1., [&](double gamma) { return modulus_ratio(law, gamma); }, from, to, n_points));
    return with_few_elements(1., region.strength ? with_strength(points, strength) : points);
  }

  std::vector<BackbonePoint> curve(const std::string& name, const Region& region, double G, double strength) const {
    const bool differs = region.strain_law && region.strength;  // from cell to cell
    std::vector<BackbonePoint> points;
    if (const auto known = curves_.find(name); known != curves_.end() && !differs)
      points = known->second;
    else
      points = curves_[name] = unit_curve(region, strength / G);
    for (BackbonePoint& point : points) {
      if (!region.strain_law) point = {point.gamma * strength / G, point.tau * strength / G};
      point.tau *= G;
    }
    return points;
  }

  PointsOfCells hysteretic(const std::string& name, const Region& region, const ElasticLaw& elastic, std::size_t i,
                           double area, RestReport& report) const {
    double strength = 0.;
    if (region.strength) {
      const double phi = region.strength->friction_angle * degree;
      strength =
          region.strength->cohesion * std::cos(phi) + std::max(rest_.mean(i, k0_), floor_.at(name)) * std::sin(phi);
    }
    const auto law = std::make_shared<const HystereticLaw>(elastic, curve(name, region, elastic.G, strength));
    HystereticLaw::State state = law->at_rest();
    if (start_ != RestStart::virgin) {
      const double k0 = earth_pressure_at_rest(region, k0_), vertical = -rest_.vertical[i];
      const PlaneStress stress = start_ == RestStart::gravity ? at_rest(rest_, i, k0_)
                                                              : PlaneStress{k0 * vertical, vertical, 0., k0 * vertical};
      state = law->bearing(stress);
      if (shear(stress) > law->strength() * (1. + 1e-9)) report.beyond += area;
    }
    return [law, state](unsigned, unsigned) { return soil_point(law, state); };
  }

  /// Shear stress of pure shear with the same norm of the deviator: sqrt(s : s / 2).
  static double shear(const PlaneStress& s) {
    const double mean = (s.xx + s.yy + s.zz) / 3., xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean;
    return std::sqrt(0.5 * (xx * xx + yy * yy + zz * zz) + s.xy * s.xy);
  }

  std::optional<double> k0_;
  const EffectiveStress& rest_;
  RestStart start_;
  const PointStresses* failing_;
  std::map<std::string, double> floor_;
  mutable std::map<std::string, std::vector<BackbonePoint>> curves_;  ///< by region
  std::shared_ptr<CompactingPoints> compacting_ = std::make_shared<CompactingPoints>();
};

}  // namespace

SoilLaws soil_laws(const Scene& scene, const Space& space, const EffectiveStress& rest, RestStart start,
                   const PointStresses* failing) {
  const Maker maker(scene, space, rest, start, failing);
  SoilLaws laws;
  laws.compacting = maker.compacting();
  auto of_cell = std::make_shared<std::vector<PointsOfCells>>(space.mesh().triangulation.n_active_cells());
  for (const Cell& cell : space.dofs().active_cell_iterators())
    if (space.has_matrices(cell) && space.region(cell).law != SoilLaw::elastic)
      (*of_cell)[cell->active_cell_index()] = maker.of(space, cell, laws.report);
  laws.points = [of_cell](unsigned cell, unsigned point) {
    return (*of_cell)[cell] ? (*of_cell)[cell](cell, point) : std::unique_ptr<SoilPoint>();
  };
  return laws;
}

}  // namespace upbead
