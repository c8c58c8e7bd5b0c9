// Water beside the walls of a rigid caisson that no mesh has: a mass that swings with them.
#pragma once

#include <vector>

#include "fem/caisson/caisson.h"

namespace upbead {

/// The moments of the mass of water of a height h (m) beside a wall that rises from the base: of its horizontal
/// acceleration at the base, mass (kg/m), first (kg) and second (kg m) moment about the base.
struct WallMass {
  double mass = 0., first = 0., second = 0.;
};

/// By the pressure 7/8 rho sqrt(h d) a at the depth d that Westergaard (Trans. ASCE 98 (1933) 418, eq. 41) gives a
/// stiff wall, with a that of the wall at that depth: 7/12 rho h^2, 7/30 rho h^3, 2/15 rho h^4. Incompressible water
/// beside a wall that does not turn has 0.5428 rho h^2 and 0.2179 rho h^3.
WallMass westergaard(double density, double height);
/// Of both walls together.
WallMass beside_walls(const WallWater& heights, double density);

/// Adds to M and to the forces of the water what [regions.caisson.added_mass] asks for.
class BesideWalls {
 public:
  BesideWalls(const Region& region, double density, const Unknowns& unknowns, const std::vector<Body>& bodies,
              const Caisson& caisson);
  const FaceTerms& terms() const { return terms_; }
  void add_to(CaissonForces& forces) const;

 private:
  FaceTerms terms_;   ///< over the body's sway and rotation
  Row front_, back_;  ///< horizontal force of the walls on the water, over their accelerations
};

}  // namespace upbead
