#include "run/construction.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <map>

#include "base/progress.h"
#include "base/text.h"
#include "run/derived.h"
#include "upbead/waves/edge_pressures.h"

namespace upbead {

namespace {

constexpr double end_of_scale = 10.;  // of the mobilised share, as of stresses during the waves
constexpr double least_stress = 0.1;  // over the mean of a region: free surfaces have no strength to speak of

using MeshCell = dealii::Triangulation<dim>::active_cell_iterator;

double mean_in_plane(const PlaneStress& s) {
  return -0.5 * (s.xx + s.yy);
}

/// (s1 - s3)/2 over c' cos phi' + s sin phi' in the plane, s the mean of s1 and s3.
double mobilised(const PlaneStress& s, const Strength& strength) {
  const double phi = strength.friction_angle * boost::math::constants::degree<double>();
  const double radius = std::hypot(0.5 * (s.xx - s.yy), s.xy);
  const double bearable = strength.cohesion * std::cos(phi) + mean_in_plane(s) * std::sin(phi);
  return bearable * end_of_scale > radius ? radius / bearable : end_of_scale;
}

/// Where every point is within the strength, so is their mean.
PlaneStress mean_of(const std::vector<PlaneStress>& points) {
  PlaneStress mean;
  for (const PlaneStress& s : points) mean = sum(mean, s);
  const double share = 1. / static_cast<double>(points.size());
  return {share * mean.xx, share * mean.yy, share * mean.xy, share * mean.zz};
}

/// Looks at what stands in a stage: cells that have stresses.
class StageReader {
 public:
  StageReader(const Simulation& simulation, const BuiltStage& built)
      : scene_(simulation.scene()), mesh_(*simulation.mesh()), built_(built) {}

  /// Largest settlement of a vertex of the ground; none where the motion is not known.
  void settle(StageSummary& stage) const {
    if (built_.moved.empty()) return;
    for_each_soil([&](const MeshCell& cell, const std::vector<PlaneStress>&) {
      for (const unsigned v : cell->vertex_indices()) {
        const double down = -built_.moved[cell->vertex_index(v)][1];
        if (stage.settlement && down <= *stage.settlement) continue;
        stage.settlement = down;
        stage.settlement_at = {cell->vertex(v)[0], cell->vertex(v)[1]};
      }
    });
  }

  void mobilise(StageSummary& stage) const {
    const std::map<std::string, double> least = least_stresses();
    bool fails = false;
    for_each_soil([&](const MeshCell& cell, const std::vector<PlaneStress>& points) {
      const std::string& name = mesh_.surface_of(cell);
      const Region& region = scene_.regions.at(name);
      fails = fails || region.law == SoilLaw::mohr_coulomb;
      const PlaneStress stress = mean_of(points);
      if (!region.strength || mean_in_plane(stress) < least.at(name)) return;
      const double share = mobilised(stress, *region.strength);
      if (stage.mobilised && share <= *stage.mobilised) return;
      stage.mobilised = share;
      stage.mobilised_at = {cell->center()[0], cell->center()[1]};
      stage.mobilised_in = name;
    });
    if (fails) stage.share_at_strength = built_.share_at_strength;
  }

 private:
  template <class Visit>
  void for_each_soil(const Visit& visit) const {
    for (const auto& cell : mesh_.triangulation.active_cell_iterators()) {
      const std::vector<PlaneStress>& points = built_.stresses[cell->active_cell_index()];
      if (!points.empty() && mesh_.surface_of(cell) != caisson_name) visit(cell, points);
    }
  }

  std::map<std::string, double> least_stresses() const {
    std::map<std::string, double> sum, area;
    for_each_soil([&](const MeshCell& cell, const std::vector<PlaneStress>& points) {
      sum[mesh_.surface_of(cell)] += area_of(cell) * std::max(mean_in_plane(mean_of(points)), 0.);
      area[mesh_.surface_of(cell)] += area_of(cell);
    });
    for (auto& [name, value] : sum) value *= least_stress / area.at(name);
    return sum;
  }

  const Scene& scene_;
  const Mesh& mesh_;
  const BuiltStage& built_;
};

CaissonMotion motion_of(const std::array<double, n_motions>& motion) {
  return {-motion[motion_y], motion[motion_x], motion[motion_rotation]};
}

StageSummary stage_of(const Simulation& simulation, const BuiltStage& built, bool is_first) {
  StageSummary stage;
  stage.name = built.name;
  stage.regions = join(simulation.scene().construction.at(built.name).regions);
  stage.weight = built.weight;
  const StageReader reader(simulation, built);
  if (!is_first) reader.settle(stage);  // ground as it is found has settled long ago
  reader.mobilise(stage);
  if (built.caisson && !is_first) stage.caisson = motion_of(*built.caisson);
  if (built.base) {
    const EdgePressures edges = edge_pressures(built.base->force, built.base->moment, built.base->width);
    stage.heel_pressure = edges.landward;
    stage.toe_pressure = edges.seaward;
  }
  return stage;
}

}  // namespace

std::optional<ConstructionSummary> construction_of(const Simulation& simulation, const RestState& rest) {
  if (simulation.scene().construction.empty()) return std::nullopt;
  ConstructionSummary construction;
  construction.falls_in = rest.falls_in;
  bool is_known = true;
  CaissonMotion since;
  for (const BuiltStage& built : rest.built) {
    construction.stages.push_back(stage_of(simulation, built, construction.stages.empty()));
    const auto& moved = construction.stages.back().caisson;
    is_known = is_known && (moved || !built.base);
    if (moved)
      since = {since.settlement + moved->settlement, since.displacement_x + moved->displacement_x,
               since.rotation + moved->rotation};
  }
  const bool stands = !rest.built.empty() && rest.built.back().base && rest.falls_in.empty();
  if (is_known && stands) construction.caisson = since;
  return construction;
}

std::optional<ConstructionSummary> build(const Simulation& simulation) {
  if (simulation.scene().construction.empty()) return std::nullopt;
  return construction_of(simulation, rest_state(simulation.scene(), *simulation.mesh(), simulation.soil_state(),
                                                shown_progress("construction")));
}

}  // namespace upbead
