// The effective load of the caisson on the ground: force and moment, eccentricity, edge pressures.
#pragma once

#include <optional>
#include <vector>

#include "output/result_file.h"
#include "upbead/run/simulation.h"
#include "upbead/sliding/base_pressure.h"

namespace upbead {

/// A load in a row of histories, where readings belong to its value before a jump.
double load_in_row(const TimeFunction& load, const std::vector<double>& time, std::size_t row);

/// The caisson's weight minus that of the water which it displaces below still water (N/m); none where the scene
/// gives no still water. Needs a caisson.
std::optional<double> weight_in_water(const Simulation& simulation);

/// How far landward of the bottom's middle the line of that weight is (m); none where it floats, too.
std::optional<double> eccentricity_in_water(const Simulation& simulation);

/// W' is that of [sliding], or the mass minus the water that the caisson displaces below still water. None without
/// either, without a caisson, or where there is no compression at rest. `ends`: all readings of the scene over time;
/// `contact`: what nodes did that slip and open.
std::optional<EffectiveBase> effective_base(const Simulation& simulation, const Series& ends,
                                            const std::optional<ContactSolution>& contact = std::nullopt);

/// The loads alone, at each time as they act on the caisson: without motion, and without the modelled pore pressure,
/// suction under an open base for instance, unless the case takes its uplift from that. `ends`: as of `base`.
EffectiveBase loads_alone(const Simulation& simulation, EffectiveBase base, const Series& ends);

/// The histories effective_normal_force, effective_base_moment, eccentricity (0 where N' <= 0), toe_pressure (of the
/// seaward edge) and heel_pressure (of the landward edge).
std::vector<Dataset> base_histories(const EffectiveBase& base);

}  // namespace upbead
