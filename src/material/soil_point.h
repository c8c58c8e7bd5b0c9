// One point of soil: its law of stress, whichever that is, and what it remembers.
#pragma once

#include <memory>

#include "material/hysteretic_law.h"
#include "material/mohr_coulomb_law.h"

namespace upbead {

/// Counts strain, stress and energy from the state at rest on.
class SoilPoint {
 public:
  virtual ~SoilPoint() = default;
  /// Change of stress since rest at a strain, from the committed state, which stays (Pa).
  virtual PlaneStress stress(const PlaneStrain& strain) = 0;
  /// The strain becomes history. Returns what was dissipated since the last commit (J/m3).
  virtual double commit(const PlaneStrain& strain) = 0;
  /// Energy stored since rest by stresses, less the work of those at rest, which weights have done (J/m3).
  virtual double stored() const = 0;
  /// Change of stress since rest at the committed strain (Pa).
  virtual PlaneStress borne() const = 0;
  /// Share of the strength that is mobilised at the committed strain, see the laws; 1 where all of it is.
  virtual double mobilised() const = 0;
};

/// Of a law whose `at_rest` bears what it bears before the waves, without strain. What the soil bears at rest beyond
/// what the law can is borne by nothing that is followed here.
std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const HystereticLaw> law, HystereticLaw::State at_rest);
std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const MohrCoulombLaw> law, const PlaneStress& at_rest);

}  // namespace upbead
