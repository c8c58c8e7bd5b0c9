// Damping of ground that is shaken as a whole: relative to the moving frame.
#pragma once

#include <map>
#include <string>

#include "fem/unknowns.h"

namespace upbead {

/// Whether a load is the motion of the frame that everything else moves in: uniform, and either of the only fixed
/// side, or of the outcrop below an absorbing side where nothing is fixed.
bool moves_frame(const Scene& scene, const Load& load);

/// What holds on `level` sides, so that they move as level ground without end does above a base that moves: sigma_x = 0
/// and u_y = 0 under shear waves, u_x = 0 and tau_xy = 0 under pressure waves; under both, only that the two sides move
/// alike.
enum class LevelSides { hold_vertically, hold_horizontally, move_alike };
LevelSides level_sides(const Scene& scene);

/// Nodal forces of a unit velocity of the frame in the load's direction, by region: Rayleigh's alpha M v damps motion
/// relative to rest, alpha M (v - v_frame) damps it relative to the frame (Chopra, Dynamics of structures (2012),
/// section 9.4).
std::map<std::string, NodalForces> damping_by_frame(const Space& space, const Load& load);

/// What two motions of one frame take together, per unit velocity of both: the integral of alpha rho d_1.d_2 (N s/m2).
double frame_damping(const Space& space, const Load& one, const Load& other);

}  // namespace upbead
