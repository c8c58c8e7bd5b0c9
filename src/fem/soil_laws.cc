#include "fem/soil_laws.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "fem/kernels.h"
#include "model/soil_law_row.h"

namespace upbead {

namespace {

/// Least mean stress for the strength, over the mean of the region: strength would vanish at free surfaces.
constexpr double least_stress = 0.1;

/// The given K_0, or that of Jaky (1944) with phi', or that of elastic soil without lateral strain.
double earth_pressure_at_rest(const Region& region, const std::optional<double>& given) {
  if (given) return *given;
  if (region.strength) return 1. - std::sin(region.strength->friction_angle * (pi / 180.));
  return *region.poissons_ratio / (1. - *region.poissons_ratio);
}

ShearCompaction compaction_of(const Densification& d) {
  return {d.C1(), d.C2(), d.threshold};
}

/// What a law is told of a region.
RegionSoil soil_of(const std::string& name, const Region& region) {
  RegionSoil soil;
  soil.region = name;
  if (const auto& s = region.strength)
    soil.strength = MohrCoulombStrength{s->friction_angle, s->cohesion, s->dilatancy_angle, s->tension};
  if (const auto& law = region.strain_law) {
    soil.curve =
        ModulusCurve{[law = *law](double gamma) { return modulus_ratio(law, gamma); }, law->reference_strain, {}};
    if (!law->modulus.empty()) soil.curve->range = std::array{law->modulus.front()[0], law->modulus.back()[0]};
  }
  return soil;
}

/// Makes the laws of a scene, cell by cell.
class Maker {
 public:
  Maker(const Scene& scene, const Space& space, const EffectiveStress& rest, RestStart start,
        const PointStresses* failing)
      : k0_(k0_of(scene)), applied_k0_(k0_to_apply(scene)), rest_(rest), start_(start), failing_(failing) {
    std::map<std::string, std::pair<double, double>> sums;  // sum of stress times area, and of area
    for (const Cell& cell : space.dofs().active_cell_iterators()) {
      auto& [stress, area] = sums[space.mesh().surface_of(cell)];
      stress += area_of(cell) * std::max(rest.mean(cell->active_cell_index(), applied_k0_), 0.);
      area += area_of(cell);
    }
    for (const auto& [name, sum] : sums) floor_[name] = least_stress * sum.first / sum.second;
  }

  PointMaker of(const Space& space, const Cell& cell, const SoilLawRow& row, SoilLaws& laws) {
    const Region& region = space.region(cell);
    const std::string name = space.mesh().surface_of(cell);
    const std::size_t i = cell->active_cell_index();
    const ElasticLaw& elastic = space.material(cell);
    const double mean = rest_.mean(i, applied_k0_);
    auto& make = make_[name];
    if (!make) make = row.make(soil_of(name, region));
    const bool balanced = row.rest == RestStress::balanced && failing_;
    const CellPoints points = make({elastic, std::max(mean, floor_.at(name)), at_rest(region, row, i)});
    laws.report.area += area_of(cell);
    if (points.beyond && !balanced) laws.report.beyond += area_of(cell);
    if (!region.densification) return points.point;
    return [=, law = compaction_of(*region.densification), compacting = row.compacting, list = laws.compacting,
            index = cell->active_cell_index()](unsigned point) {
      auto made = compacting(points.point(point), elastic, law, mean);
      list->emplace_back(index, made.get());
      return made;
    };
  }

 private:
  /// By points of quadrature, or one for all.
  std::vector<PlaneStress> at_rest(const Region& region, const SoilLawRow& row, std::size_t i) const {
    if (row.rest == RestStress::balanced) return failing_ ? failing_->at(i) : std::vector{elastic_rest(i)};
    const double vertical = -rest_.vertical[i], k0 = earth_pressure_at_rest(region, k0_);
    if (start_ == RestStart::k0) return {{k0 * vertical, vertical, 0., k0 * vertical}};
    return {start_ == RestStart::gravity ? elastic_rest(i) : PlaneStress{}};
  }
  PlaneStress elastic_rest(std::size_t i) const {
    const double vertical = -rest_.vertical[i];
    if (const auto& k0 = applied_k0_) return {*k0 * vertical, vertical, -rest_.shear[i], *k0 * vertical};
    return {-rest_.horizontal[i], vertical, -rest_.shear[i], -rest_.out_of_plane[i]};
  }

  std::optional<double> k0_, applied_k0_;
  const EffectiveStress& rest_;
  RestStart start_;
  const PointStresses* failing_;
  std::map<std::string, double> floor_;
  std::map<std::string, std::function<CellPoints(const CellSoil&)>> make_;  ///< by region
};

}  // namespace

SoilLaws soil_laws(const Scene& scene, const Space& space, const EffectiveStress& rest, RestStart start,
                   const PointStresses* failing) {
  Maker maker(scene, space, rest, start, failing);
  SoilLaws laws;
  laws.compacting = std::make_shared<CompactingPoints>();
  auto of_cell = std::make_shared<std::vector<PointMaker>>(space.mesh().triangulation.n_active_cells());
  for (const Cell& cell : space.dofs().active_cell_iterators())
    if (const SoilLawRow* row = row_of(space.region(cell).law); row && space.has_matrices(cell))
      (*of_cell)[cell->active_cell_index()] = maker.of(space, cell, *row, laws);
  laws.points = [of_cell](unsigned cell, unsigned point) {
    return (*of_cell)[cell] ? (*of_cell)[cell](point) : std::unique_ptr<SoilPoint>();
  };
  return laws;
}

}  // namespace upbead
