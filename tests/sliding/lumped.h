// Caissons that slip, made by hand.
#pragma once

#include "sliding/coupled_slip.h"
#include "sliding/elastic_block.h"
#include "upbead/system/system.h"

namespace upbead::test {

/// A block x that slips by s over a base with the motion x - s; the load is P.
System block_on_base(double mass, const ElasticBase& base);
/// The same on a base that sinks, too, with springs coupled by `coupling` (N/m2): the base presses up or down where
/// it is pushed landward. Unknowns x, y, s. Readings: the change of N', x', y', s'.
System block_on_wedge(double mass, const ElasticBase& base, double coupling);
/// A block on rigid ground: s alone.
System block_on_rock(double mass);

/// Scaled to coordinates in which T(s_0) has ones on its diagonal, as in a Krylov space.
ReducedSystem scaled(ReducedSystem reduced);
/// The slip model in all coordinates of the system, with friction and these readings; `normal`: the reading that
/// changes N', or -1.
SlipModel in_modes(System system, double friction, double shift, const std::vector<int>& wanted = {}, int normal = -1);

/// P at n samples, straight between its points, and a constant N_0.
WaveSamples samples(const History& force, double normal, double step, int n);

}  // namespace upbead::test
