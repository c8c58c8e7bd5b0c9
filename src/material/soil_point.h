// One point of soil: its law of stress, whichever that is, and what it remembers.
#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "material/hysteretic_law.h"
#include "material/mohr_coulomb_law.h"

namespace upbead {

inline PlaneStress sum(const PlaneStress& a, const PlaneStress& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy, a.zz + b.zz};
}

/// A law, what it remembers, and what it bore at rest.
template <class Law>
struct SoilOf {
  std::shared_ptr<const Law> law;
  typename Law::State now;
  PlaneStress rest;

  /// As of SoilPoint.
  double mobilised(const PlaneStress& change) const { return law->mobilised(sum(rest, change)); }
};
using HystereticSoil = SoilOf<HystereticLaw>;
using MohrCoulombSoil = SoilOf<MohrCoulombLaw>;

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
  /// Share of the strength that is mobilised where the stress has changed by so much since rest, see the laws; 1 where
  /// all of it is.
  virtual double mobilised(const PlaneStress& change) const = 0;
  /// Appends all that it has committed, for checkpoints; takes it back from there, and returns what follows.
  virtual void remember(std::vector<double>& /*memory*/) const { throw std::invalid_argument(no_memory); }
  virtual const double* recall(const double* /*memory*/) { throw std::invalid_argument(no_memory); }
  /// What it is, where SoilPack may follow it in lanes; else null.
  virtual const HystereticSoil* hysteretic() const { return nullptr; }
  virtual const MohrCoulombSoil* mohr_coulomb() const { return nullptr; }

 private:
  static constexpr const char* no_memory = "this soil keeps no checkpoints";
};

/// Of a law whose `at_rest` bears what it bears before the waves, without strain. What the soil bears at rest beyond
/// what the law can is borne by nothing that is followed here.
std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const HystereticLaw> law, HystereticLaw::State at_rest);
std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const MohrCoulombLaw> law, const PlaneStress& at_rest);

}  // namespace upbead
