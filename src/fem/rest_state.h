// The rest of soil that fails: weights that it bears within its strength, and how much less strength would do.
#pragma once

#include <optional>
#include <string>

#include "fem/static_march.h"
#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

struct RestState {
  bool found = false;
  PointStresses stresses;         ///< effective, within the strength and in equilibrium
  double share_at_strength = 0.;  ///< of the area of soil with a law of strength
  StaticReport report;
  std::string gives_way;  ///< where none is found: "region 'mound' at (3.2, 1.5) m"
};

/// Whether a region's law is Mohr-Coulomb's, which starts from such a state.
bool needs_rest_state(const Scene& scene);

/// Gravity, buoyancy, surcharges and the caisson's weight on ground whose Mohr-Coulomb regions fail and whose others
/// are elastic. The stress of the elastic ground, where K_0 is given with s'_x = s'_z = K_0 s'_y, is brought back to
/// the strength, and what of the weights that does not bear is put on in steps. By the soil's own flow; where that
/// finds no equilibrium, by associated flow, which changes which of the stresses that are in equilibrium and within the
/// strength is found. `soil`: stiffness as in the dynamic system.
RestState rest_state(const Scene& scene, const Mesh& mesh, const SoilState& soil);

/// By which factor c', tan phi' and tan psi' of all regions with a strength may fall: it stands at `lower`, and no
/// equilibrium was found at `upper`.
struct SafetyFactor {
  std::optional<double> lower;  ///< none: no equilibrium was found with 16 times its strength either
  std::optional<double> upper;  ///< none: it stands with a twentieth of its strength, too
  std::string fails_at;         ///< where: "region 'mound' at (3.2, 1.5)"; empty where it stands
};

/// Strength reduction (Zienkiewicz, Humpheson and Lewis 1975; Griffiths and Lane 1999): c'/F, tan phi'/F, tan psi'/F
/// with F in steps from a state that stands, to 1 %. Soil with a strength is Mohr-Coulomb's whatever its law in waves.
SafetyFactor safety_factor(const Scene& scene, const Mesh& mesh, const SoilState& soil);

}  // namespace upbead
