// The friction of a caisson that slips as a whole, on its reduced model.
#pragma once

#include <string>
#include <vector>

#include "dynamics/slip_model.h"

namespace upbead {

/// Which part of the uplift N' is without.
enum class SlipUplift {
  none,     ///< N' = N_0 + change of the total normal force; a prescribed uplift is part of N_0
  computed  ///< the modelled pore pressure on the bottom is taken off besides
};

/// Coulomb's law for a scene's reduced system, by the names of its readings; `wanted`: of others that are to be read.
SlipLaw slip_law(const ReducedSystem& system, double friction, SlipUplift uplift,
                 const std::vector<std::string>& wanted = {});

}  // namespace upbead
