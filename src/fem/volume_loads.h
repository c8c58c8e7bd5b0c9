// Loads on the volume of regions: body forces, gravity, sources of pore water.
#pragma once

#include <map>
#include <string>

#include "fem/unknowns.h"

namespace upbead {

/// Right-hand side of a load on volumes at f(t) = 1, by region, without the weight of rigid bodies, which follows
/// from their masses. Tested with (du, dW, -dphi), n the outward normal of sides where the pores drain, e = (0, -1):
///
///   body_force  u    +direction.du
///   gravity     u    +rho e.du                     W  +rho_f e.dW       (inertial flow)
///               phi  -(rho_f/b) e.grad dphi over cells, +(rho_f/b) dphi e.n over open sides       (Darcy flow)
///   source      phi  -dphi
///
/// Body forces as in Zienkiewicz, Chang and Bettess (1980): Darcy's law is W' = (1/b)(rho_f g e - grad p). Rows of
/// pressures that loads prescribe on open sides get nothing, as they are not solved for.
std::map<std::string, NodalForces> volume_forces(const Scene& scene, const Space& space, const Load& load);

/// Whether a load on volumes acts on that region.
bool acts_on(const Load& load, const std::string& region);

}  // namespace upbead
