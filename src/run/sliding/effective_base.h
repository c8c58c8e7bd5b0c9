// What stands on the ground under the caisson: effective force and moment, eccentricity, pressures of the edges.
#pragma once

#include <optional>
#include <vector>

#include "output/result_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Effective pressures of the edges (Pa) of a bottom of width B under `force` N' (N/m) and `moment` M' about its middle
/// (N m/m, overturning landward positive), stress linear over what touches: N'/B (1 -+ 6 e/B) where |e| = |M'/N'| <=
/// B/6, else 0 and 2 N' / (3 t), t = B/2 - |e| (the bearing pressure p_e of Goda, Random Seas and Design of Maritime
/// Structures, ch. 4). A bottom that stands on its edge would crush it: t >= B/1000. 0 where N' <= 0.
struct EdgePressures {
  double seaward = 0., landward = 0.;
};
EdgePressures edge_pressures(double force, double moment, double width);

/// Over time. N' = W' + change of the normal force - U, M' = W' e_0 + base moment + M_U about the bottom's middle,
/// overturning landward positive; U the modelled pore pressure's and a prescribed one; e_0 how far W' acts landward of
/// the middle.
struct EffectiveBase {
  double width = 0.;                          ///< B (m)
  double weight = 0., weight_moment = 0.;     ///< W' (N/m), W' e_0 (N m/m)
  std::vector<double> uplift, uplift_moment;  ///< U (N/m), M_U (N m/m)
  std::vector<double> force;                  ///< N' (N/m), compression positive
  std::vector<double> moment;                 ///< M' (N m/m)
};

/// W' is that of [sliding], or the mass less the water that the caisson displaces below still water. None without
/// either, without a caisson, or where nothing presses at rest. `ends`: all readings of the scene over time.
std::optional<EffectiveBase> effective_base(const Simulation& simulation, const Series& ends);

/// At rest and at the worst of these times, and the largest stress of a node of the base by `series`, where the scene
/// reads it.
BaseSummary base_summary(const Simulation& simulation, const EffectiveBase& base, const Series& series,
                         const std::optional<ContactHistory>& contact);

/// The histories effective_normal_force, effective_base_moment, eccentricity (0 where N' <= 0), toe_pressure (of the
/// seaward edge) and heel_pressure (of the landward edge).
std::vector<Dataset> base_histories(const EffectiveBase& base);

}  // namespace upbead
