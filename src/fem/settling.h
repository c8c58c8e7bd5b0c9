// How a rigid caisson settles and tilts where the ground under it loses volume.
#pragma once

#include <optional>
#include <vector>

#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

struct SettledBody {
  double down = 0.;      ///< of the middle of its bottom (m)
  double rotation = 0.;  ///< landward positive (rad)
};

/// By how much each list of volumetric strains by active cell index (NaN: none) settles the caisson. The strain is one
/// of height alone, as measured in samples that cannot widen; the drained ground around it is elastic, with the
/// stiffness of `soil`, and the caisson is bonded to it. None where the caisson deforms or is missing. Throws
/// NumericsError where the ground is not held.
std::vector<std::optional<SettledBody>> settled_caisson(const Scene& scene, const Mesh& mesh, const SoilState& soil,
                                                        const std::vector<std::vector<double>>& strains);

}  // namespace upbead
