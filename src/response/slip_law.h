// The friction of a caisson that slips as a whole, on its reduced model.
#pragma once

#include <string>
#include <vector>

#include "dynamics/slip_model.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Coulomb's law for a scene's reduced system, by the names of its readings. N' is N_0 plus the change of the total
/// normal force, minus the modelled pore pressure on the bottom where the uplift is computed; a prescribed uplift is
/// part of N_0. `outputs`: other readings.
SlipLaw slip_law(const ReducedSystem& system, double friction, UpliftKind uplift,
                 const std::vector<std::string>& outputs = {});

/// Whether waves press on the landward wall alone, by the largest and the least force on the caisson: then all is as in
/// a mirror. What is landward may be noise of a record, a twentieth of the rest at most.
bool pushes_seaward_alone(double largest, double least);

/// Adds another load with these values at the times.
SampledLoads with_load(SampledLoads loads, const Eigen::RowVectorXd& values);

}  // namespace upbead
