// The state at rest of soil that fails: it bears the weights within its strength; and its factor of safety.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fem/construction.h"
#include "fem/static_march.h"
#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

struct RestState {
  bool found = false;
  PointStresses stresses;         ///< effective, within the strength and in equilibrium
  double share_at_strength = 0.;  ///< share of the area of soil with a law of strength that is at its strength
  StaticReport report;
  std::string gives_way;  ///< where it shears most as it fails, if none is found: "region 'mound' at (3.2, 1.5) m"
  bool none = false;      ///< shown that there is none, rather than not found
  std::vector<BuiltStage> built{};  ///< stages of construction that have a rest, in their order
  std::string falls_in{};           ///< the stage that has none; "" where all have, and of a scene without stages
};

/// Whether a region has the Mohr-Coulomb law, which starts from such a state.
bool needs_rest_state(const Scene& scene);

/// Is called often during long work with the share that is done; may throw to end it.
using RestProgress = std::function<void(double)>;

/// Gravity, buoyancy, surcharges and the caisson's weight on ground whose Mohr-Coulomb regions may fail and whose
/// other regions are elastic. The stress of the elastic ground (where K_0 is given, with s'_x = s'_z = K_0 s'_y) is
/// returned to the strength, and the weights that it then does not bear are applied in steps. With the soil's own
/// flow rule; where that finds no equilibrium, with associated flow: this selects another of the stress states that
/// are in equilibrium and within the strength. Where seek_rest shows that there is none, no more steps are tried.
/// `soil`: stiffness as in the dynamic system. A scene that is built in stages comes to rest stage by stage, each from
/// the stresses of the last one, what appears from none; K_0 holds in the first.
RestState rest_state(const Scene& scene, const Mesh& mesh, const SoilState& soil, const RestProgress& progress = {});

/// Factor by which c', tan phi' and the tensile strength of all regions with a strength may be divided: a stress
/// within that strength is in equilibrium at `lower`, none is at `upper`.
struct SafetyFactor {
  std::optional<double> lower;  ///< none: no rest was found even with 16 times the strength
  std::optional<double> upper;  ///< none: the ground was not seen to fail even with a twentieth of its strength
  std::string fails_at;         ///< where it shears most as it fails: "region 'mound' at (3.2, 1.5) m"; or empty
  std::string why;              ///< why no bracket as close as asked for was found; empty where it was
};

/// Strength reduction (Zienkiewicz, Humpheson and Lewis 1975; Griffiths and Lane 1999) to 0.5 %. Every factor is judged
/// by seek_rest from the elastic state, so that no failure of a solver counts as one of the ground. All soil with a
/// strength follows Mohr-Coulomb here, whatever its law in waves.
SafetyFactor safety_factor(const Scene& scene, const Mesh& mesh, const SoilState& soil,
                           const RestProgress& progress = {});

}  // namespace upbead
