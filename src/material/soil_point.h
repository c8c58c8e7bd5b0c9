// One point of soil: its law of stress, whichever it is, and its history.
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

/// A law, its committed state, and its stress at rest.
template <class Law>
struct SoilOf {
  std::shared_ptr<const Law> law;
  typename Law::State now;
  PlaneStress rest;

  /// As in SoilPoint.
  double mobilised(const PlaneStress& change) const { return law->mobilised(sum(rest, change)); }
};
using HystereticSoil = SoilOf<HystereticLaw>;
using MohrCoulombSoil = SoilOf<MohrCoulombLaw>;

/// A point of soil; strain, stress and energy are counted from the state at rest.
class SoilPoint {
 public:
  virtual ~SoilPoint() = default;
  /// Change of stress since rest at a strain, starting from the committed state, which is not changed (Pa).
  virtual PlaneStress stress(const PlaneStrain& strain) = 0;
  /// Commits the strain. Returns the energy dissipated since the last commit (J/m3).
  virtual double commit(const PlaneStrain& strain) = 0;
  /// Energy stored since rest, less the work of the stresses at rest, which weights have done (J/m3).
  virtual double stored() const = 0;
  /// Share of the strength that is mobilised after that change of stress since rest (see the laws); 1 if all is
  /// mobilised.
  virtual double mobilised(const PlaneStress& change) const = 0;
  /// Appends the committed history, for checkpoints; recall() reads it back and returns the position behind it.
  virtual void remember(std::vector<double>& /*memory*/) const { throw std::invalid_argument(no_memory); }
  virtual const double* recall(const double* /*memory*/) { throw std::invalid_argument(no_memory); }
  /// The soil's data if SoilPack can compute it in lanes; else null.
  virtual const HystereticSoil* hysteretic() const { return nullptr; }
  virtual const MohrCoulombSoil* mohr_coulomb() const { return nullptr; }

 private:
  static constexpr const char* no_memory = "this soil keeps no checkpoints";
};

/// A point whose law bears `at_rest` before the waves, at zero strain. No law follows the stress at rest in excess of
/// what the law can bear.
std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const HystereticLaw> law, HystereticLaw::State at_rest);
std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const MohrCoulombLaw> law, const PlaneStress& at_rest);

}  // namespace upbead
