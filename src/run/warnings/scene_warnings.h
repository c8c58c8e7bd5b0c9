// What may be wrong with the numbers of a scene, one question a function; told before anything is solved.
#pragma once

#include <optional>

#include "upbead/base/numbered_warning.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// How long the shortest wave of a scene takes to pass (s): D + B/V_s, D the loads' shortest duration, B the width of
/// the caisson's bottom and V_s the slowest shear wave of the ground near it; D alone without a caisson. None where no
/// load has a duration, or nothing has inertia.
std::optional<double> passing_time(const Simulation& simulation);

/// step_too_coarse: a march in steps that the case gives, longer than an 8th of passing_time (order 4) or a 32nd of it
/// (order 2). None where a reduced model answers.
NumberedWarnings step_warnings(const Simulation& simulation);

/// jump_with_alpha: consolidation under a load that jumps, marched by generalised-alpha.
NumberedWarnings jump_warnings(const Simulation& simulation);

/// mesh_too_coarse: fewer than 4 cells to a wave (response/wave_resolution.h), 3 where u is of degree 3; not
/// where the mesh was made for the tolerance.
NumberedWarnings mesh_warnings(const Simulation& simulation);

/// mesh_too_coarse: a thin soft layer whose cells are longer than it is thick (response/thin_layers.h).
NumberedWarnings thin_layer_warnings(const Simulation& simulation);

/// walls_too_near: the first echo of a far side is back before the end (of sides beyond 5 B before 1/1.2 of it),
/// and the loads are shorter than it takes, or the side is nearer than the caisson is wide. `peak_time`: of F_T, where
/// that is known.
NumberedWarnings wall_warnings(const Simulation& simulation, const std::optional<double>& peak_time);

/// fast_load: all that pushes the rigid caisson is over before sound has crossed it four times.
NumberedWarnings load_warnings(const Simulation& simulation);

/// smallest_step: the pressure that somebody looks at, by a probe or in fields, oscillates from cell to cell beside a
/// face where soil drains (response/drained_skin.h).
NumberedWarnings skin_warnings(const Simulation& simulation);

/// stress_rings: a load acts on ground that deforms, and its cells do not carry its waves to a probe there, or to the
/// fields, as the equations would (response/carried_pulse.h): by more than 5 %. The worst of all loads and regions.
NumberedWarnings ring_warnings(const Simulation& simulation);

/// slow_wave_unresolved: the same of the wave of the pore water against the skeleton where flow is inertial, which
/// pressures carry, of a degree less than displacements.
NumberedWarnings slow_wave_warnings(const Simulation& simulation);

/// drained_layer: soil under the caisson drains by the size of its cells, not by its conductivity, which softens the
/// ground so much that F_T may err by more than 5 % (response/drained_layer.h); not where the mesh was made for the
/// tolerance.
NumberedWarnings layer_warnings(const Simulation& simulation);

}  // namespace upbead
