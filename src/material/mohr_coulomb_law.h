// Soil that fails where shear stress exceeds friction and cohesion: perfectly plastic, on the current effective stress.
#pragma once

#include "material/law_answer.h"
#include "material/mohr_coulomb_planes.h"

namespace upbead {

struct MohrCoulombStrength {
  double friction_angle = 0.;   ///< phi' (degrees), below 90
  double cohesion = 0.;         ///< c' (Pa)
  double dilatancy_angle = 0.;  ///< psi' (degrees), from 0 to phi'
  double tension = 0.;          ///< largest tensile stress (Pa); never above c' / tan phi'
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

  /// The stress is the effective one, including that at rest. Dissipation is the stress at the end times the plastic
  /// strain. Throws NumericsError where the return finds no set of planes: the strain is not finite.
  LawAnswer update(const PlaneStrain& strain, State& state) const;
  /// Energy stored (J/m3): sigma : D^-1 : sigma / 2.
  double stored(const State& state) const;
  /// Largest excess of a stress over the planes (Pa); negative inside.
  double excess(const PlaneStress& stress) const;
  /// The stress to which a trial stress outside the planes returns. Throws as update does.
  PlaneStress returned(const PlaneStress& trial) const;
  const ElasticLaw& elastic() const { return elastic_; }
  const MohrCoulombPlanes& planes() const { return planes_; }
  /// (s1 - s3)/2 over c' cos phi' - (s1 + s3)/2 sin phi'; 1 where s1 has reached the limit of tension.
  double mobilised(const PlaneStress& stress) const;

 private:
  double dissipated(const PlaneStress& stress, const PlaneStress& relaxed) const;

  ElasticLaw elastic_;
  MohrCoulombPlanes planes_;
};

}  // namespace upbead
