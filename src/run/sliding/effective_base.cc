#include "run/sliding/effective_base.h"

#include <algorithm>
#include <cmath>

#include "fem/caisson/readings.h"
#include "fem/static_stage.h"
#include "run/sliding/case_sliding.h"

namespace upbead {

EdgePressures edge_pressures(double force, double moment, double width) {
  if (!(force > 0.)) return {};
  const double e = moment / force, least = 1e-3 * width;
  if (std::abs(e) <= width / 6.) return {force / width * (1. - 6. * e / width), force / width * (1. + 6. * e / width)};
  const double edge = 2. * force / (3. * std::max(0.5 * width - std::abs(e), least));
  return e > 0. ? EdgePressures{0., edge} : EdgePressures{edge, 0.};
}

namespace {

/// At rest, on the ground.
struct RestingForces {
  double force = 0.;   ///< W' (N/m)
  double moment = 0.;  ///< about the bottom's middle, overturning landward positive (N m/m)
};

/// Weight less the water that the caisson displaces; a cell that the level cuts displaces its part below.
RestingForces submerged_weight(const Simulation& simulation, double level) {
  const Caisson& caisson = *simulation.compiled->caisson;
  const double middle = caisson.bottom_centre[0], g = simulation.scene.gravity;
  RestingForces rest{caisson.body.mass * g, caisson.body.mass * g * (caisson.body.centre[0] - middle)};
  for (const auto& cell : simulation.mesh->triangulation.active_cell_iterators()) {
    if (simulation.mesh->surface_of(cell) != caisson.body.region) continue;
    double low = cell->vertex(0)[1], high = low;
    for (const unsigned v : cell->vertex_indices()) {
      low = std::min(low, cell->vertex(v)[1]);
      high = std::max(high, cell->vertex(v)[1]);
    }
    const double wet = std::clamp((level - low) / (high - low), 0., 1.);
    const double lift = simulation.scene.fluid.density * g * wet * cell->measure();
    rest.force -= lift;
    rest.moment -= lift * (cell->center()[0] - middle);
  }
  return rest;
}

std::optional<RestingForces> at_rest(const Simulation& simulation) {
  const double level = water_level(simulation.scene, *simulation.mesh);
  const auto& sliding = simulation.scene.sliding;
  if (!std::isfinite(level) && !sliding) return std::nullopt;
  RestingForces rest = submerged_weight(simulation, std::isfinite(level) ? level : -1e300);
  if (!sliding) return rest;
  rest.moment *= sliding->submerged_weight / rest.force;
  rest.force = sliding->submerged_weight;
  return rest;
}

/// A prescribed uplift at those times; zeros without one.
std::vector<double> relief(const Simulation& simulation, const std::vector<double>& time) {
  std::vector<double> uplift(time.size(), 0.);
  const auto& sliding = simulation.scene.sliding;
  if (time.empty() || !sliding || !sliding->uplift || sliding->uplift->kind != UpliftKind::prescribed) return uplift;
  const TimeFunction prescribed = prescribed_uplift(simulation.scene, *simulation.compiled, time);
  for (std::size_t i = 0; i < time.size(); ++i) uplift[i] = prescribed(time[i]);
  return uplift;
}

}  // namespace

std::optional<EffectiveBase> effective_base(const Simulation& simulation, const Series& ends) {
  if (!simulation.compiled->caisson) return std::nullopt;
  const std::optional<RestingForces> rest = at_rest(simulation);
  if (!rest || !(rest->force > 0.)) return std::nullopt;
  const System& system = simulation.compiled->system;
  const auto row = [&](const char* name) { return ends.reading.row(system.reading(name)); };
  const auto N = row(reading::normal_force), M = row(reading::base_moment), U = row(reading::uplift),
             M_U = row("uplift_moment");
  const std::vector<double> prescribed = relief(simulation, ends.time);
  EffectiveBase base{simulation.compiled->caisson->bottom_width, {}, {}};
  for (std::size_t i = 0; i < ends.time.size(); ++i) {
    const auto t = static_cast<Eigen::Index>(i);
    base.force.push_back(rest->force + N[t] - U[t] - prescribed[i]);
    base.moment.push_back(rest->moment + M[t] + M_U[t]);
  }
  return base;
}

std::vector<Dataset> base_histories(const EffectiveBase& base) {
  std::vector<double> eccentricity, toe, heel;
  for (std::size_t i = 0; i < base.force.size(); ++i) {
    eccentricity.push_back(base.force[i] > 0. ? base.moment[i] / base.force[i] : 0.);
    const EdgePressures edges = edge_pressures(base.force[i], base.moment[i], base.width);
    toe.push_back(edges.seaward);
    heel.push_back(edges.landward);
  }
  return {
      {"effective_normal_force", "N/m", "N' on the bottom, at rest and changed, compression positive", base.force},
      {"effective_base_moment", "N m/m", "M' about the bottom's middle, overturning landward positive", base.moment},
      {"eccentricity", "m", "M'/N', landward of the bottom's middle; 0 where N' is not positive", eccentricity},
      {"toe_pressure", "Pa", "effective pressure of the seaward edge, stress linear over the bottom", toe},
      {"heel_pressure", "Pa", "effective pressure of the landward edge, stress linear over the bottom", heel}};
}

}  // namespace upbead
