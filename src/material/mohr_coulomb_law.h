// Soil that fails where shear stress exceeds friction and cohesion: perfectly plastic, on the current effective stress.
#pragma once

#include "material/mohr_coulomb_planes.h"
#include "material/soil_law.h"

namespace upbead {

/// Derivative of (sigma_xx, sigma_yy, sigma_xy) by (eps_xx, eps_yy, gamma_xy) (Pa); symmetric for associated flow.
using Tangent = std::array<std::array<double, 3>, 3>;

struct LawAnswer {
  PlaneStress stress;  ///< Pa
  Tangent tangent{};   ///< at the end of the step, consistent with the update
};

/// With principal stresses s1 >= s2 >= s3, tension positive, k = (1 + sin phi)/(1 - sin phi), m the same with psi:
///   k s1 - s3 <= 2 c sqrt(k), flow by m s1 - s3;  s1 <= tension, flow associated.
/// These are planes in the space of principal stresses: the return to a plane, an edge or a corner is exact (Clausen,
/// Damkilde and Andersen 2006). Which of them applies is found by trying sets of planes. sigma_zz counts as a
/// principal stress.
class MohrCoulombLaw {
 public:
  struct State {
    PlaneStress stress;  ///< effective (Pa)
    PlaneStrain strain;  ///< the strain at that stress
  };

  /// Throws InputError, all mistakes at once, where an angle or a strength is out of its range.
  MohrCoulombLaw(const ElasticLaw& elastic, const MohrCoulombStrength& strength);

  /// Changes the state last committed to the one at the given strain. A solver that iterates must call it each time
  /// with a copy of the committed state: a path of iterates is not real. Throws NumericsError where the return finds no
  /// set of planes: the strain is not finite.
  LawAnswer update(const PlaneStrain& strain, State& state) const;
  /// Largest excess of a stress over the planes (Pa); negative inside.
  double excess(const PlaneStress& stress) const;
  /// The stress to which a trial stress outside the planes returns. Throws as update does.
  PlaneStress returned(const PlaneStress& trial) const;
  const ElasticLaw& elastic() const { return elastic_; }
  const MohrCoulombPlanes& planes() const { return planes_; }
  /// (s1 - s3)/2 over c' cos phi' - (s1 + s3)/2 sin phi'; 1 where s1 has reached the limit of tension.
  double mobilised(const PlaneStress& stress) const;

 private:
  ElasticLaw elastic_;
  MohrCoulombPlanes planes_;
};

/// Points of a cell that start from these stresses at rest, one for each point or one for all; where one exceeds the
/// strength, from what it returns to. Dissipation is the stress at the end times the plastic strain; the energy stored
/// is sigma : D^-1 : sigma / 2.
PointMaker mohr_coulomb_points(std::shared_ptr<const MohrCoulombLaw> law, std::vector<PlaneStress> at_rest);

extern const SoilLawRow mohr_coulomb_row;

}  // namespace upbead
