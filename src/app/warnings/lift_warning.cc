#include "lift_warning.h"

#include <algorithm>
#include <cmath>

#include "../sliding/case_sliding.h"
#include "upbead/app/report.h"
#include "upbead/base/text.h"
#include "upbead/fem/caisson_readings.h"
#include "upbead/fem/static_stage.h"

namespace upbead {

namespace {

/// A rigid bottom on elastic ground has more stress at its edges than a straight line tells: it opens at 1.26 times the
/// moment by which that pulls, docs/slip.md.
constexpr double edge_factor = 1.26;

/// At rest, on the ground.
struct Rest {
  double force = 0.;   ///< W' (N/m)
  double moment = 0.;  ///< about the bottom's middle, overturning landward positive (N m/m)
};

/// Weight less the water that the caisson displaces; a cell that the level cuts displaces its part below.
Rest submerged_weight(const CompiledCase& scene, double level) {
  const Caisson& caisson = *scene.compiled.caisson;
  const double middle = caisson.bottom_centre[0], g = scene.scene.gravity;
  Rest rest{caisson.body.mass * g, caisson.body.mass * g * (caisson.body.centre[0] - middle)};
  for (const auto& cell : scene.mesh->triangulation.active_cell_iterators()) {
    if (scene.mesh->surface_of(cell) != caisson.body.region) continue;
    double low = cell->vertex(0)[1], high = low;
    for (const unsigned v : cell->vertex_indices()) {
      low = std::min(low, cell->vertex(v)[1]);
      high = std::max(high, cell->vertex(v)[1]);
    }
    const double wet = std::clamp((level - low) / (high - low), 0., 1.);
    const double lift = scene.scene.fluid.density * g * wet * cell->measure();
    rest.force -= lift;
    rest.moment -= lift * (cell->center()[0] - middle);
  }
  return rest;
}

std::optional<Rest> at_rest(const CompiledCase& scene) {
  const double level = water_level(scene.scene, *scene.mesh);
  const auto& sliding = scene.scene.sliding;
  if (!std::isfinite(level) && !sliding) return std::nullopt;
  Rest rest = submerged_weight(scene, std::isfinite(level) ? level : -1e300);
  if (!sliding) return rest;
  rest.moment *= sliding->buoyant_weight / rest.force;
  rest.force = sliding->buoyant_weight;
  return rest;
}

/// The least stress of an edge.
struct EdgeStress {
  double stress = 0.;  ///< Pa, compression positive
  double force = 0., moment = 0., time = 0.;
};

EdgeStress least_edge_stress(const CompiledCase& scene, const Series& ends, const Rest& rest) {
  const System& system = scene.compiled.system;
  const auto row = [&](const char* name) { return ends.reading.row(system.reading(name)); };
  const auto N = row(reading::normal_force), M = row(reading::base_moment), U = row(reading::uplift),
             M_U = row("uplift_moment");
  const double B = scene.compiled.caisson->bottom_width;
  std::vector<double> relief(ends.time.size(), 0.);
  const auto& sliding = scene.scene.sliding;
  if (sliding && sliding->uplift && sliding->uplift->kind == UpliftKind::prescribed) {
    const TimeFunction prescribed = prescribed_uplift(scene.scene, scene.compiled, ends.time);
    for (std::size_t i = 0; i < relief.size(); ++i) relief[i] = prescribed(ends.time[i]);
  }
  EdgeStress least{1e300};
  for (std::size_t i = 0; i < ends.time.size(); ++i) {
    const auto t = static_cast<Eigen::Index>(i);
    const double force = rest.force + N[t] - U[t] - relief[i], moment = rest.moment + M[t] + M_U[t];
    const double stress = force / B - 6. * std::abs(moment) / (edge_factor * B * B);
    if (stress < least.stress) least = {stress, force, moment, ends.time[i]};
  }
  return least;
}

}  // namespace

NumberedWarnings lift_warnings(const CompiledCase& scene, const Run& run) {
  if (!scene.compiled.caisson || run.summary.contact) return {};
  const std::optional<Rest> rest = at_rest(scene);
  if (!rest || !(rest->force > 0.)) return {};
  const EdgeStress least = least_edge_stress(scene, run.response.ends, *rest);
  if (least.stress >= 0.) return {};
  const std::string which = least.force < 0.    ? "the whole caisson"
                            : least.moment > 0. ? "its seaward edge"
                                                : "its landward edge";
  return {{"would_lift", least.stress, 0., "Pa",
           which + " would pull at the ground with " + with_unit(-least.stress, "Pa") + " at " +
               significant(least.time) + " s (N' = " + with_unit(least.force, "N/m") + ", moment " +
               with_unit(least.moment, "N m/m") +
               "), which a tied bottom holds and a real one does not: write [regions.caisson.interface] kind = "
               "\"friction\""}};
}

}  // namespace upbead
