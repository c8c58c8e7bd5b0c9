#include "lift_warning.h"

#include <cmath>

#include "../sliding/effective_base.h"
#include "base/text.h"

namespace upbead {

namespace {

/// A rigid bottom on elastic ground has more stress at its edges than a straight line tells: it opens at 1.26 times the
/// moment by which that pulls, docs/slip.md.
constexpr double edge_factor = 1.26;

/// The least stress of an edge.
struct EdgeStress {
  double stress = 0.;  ///< Pa, compression positive
  double force = 0., moment = 0., time = 0.;
};

EdgeStress least_edge_stress(const EffectiveBase& base, const std::vector<double>& time) {
  EdgeStress least{1e300};
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double B = base.width, force = base.force[i], moment = base.moment[i];
    const double stress = force / B - 6. * std::abs(moment) / (edge_factor * B * B);
    if (stress < least.stress) least = {stress, force, moment, time[i]};
  }
  return least;
}

}  // namespace

NumberedWarnings lift_warnings(const Simulation& simulation, const Run& run) {
  if (run.summary.contact) return {};
  const std::optional<EffectiveBase> base = effective_base(simulation, run.response.ends);
  if (!base) return {};
  const EdgeStress least = least_edge_stress(*base, run.response.ends.time);
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
