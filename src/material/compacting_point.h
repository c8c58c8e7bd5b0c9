// A point of soil that packs denser under cycles of shear, whichever law its shear stress follows.
#pragma once

#include <memory>

#include "material/densification.h"
#include "material/soil_point.h"

namespace upbead {

/// What compaction does is an eigenstrain: without room to shrink the mean effective stress falls by K eps_v,
/// isotropic. It falls to zero and no further, what is left of eps_v waits until grains press again. It is taken in at
/// the commits: within a step it stays, and what it takes from the energy that is stored at a strain is dissipated, 0
/// or more.
class CompactingPoint : public SoilPoint {
 public:
  /// `mean_at_rest`: mean effective stress, compression positive (Pa).
  CompactingPoint(const ShearCompaction& law, double mean_at_rest)
      : cycles_(law), mean_at_rest_(mean_at_rest), least_mean_(mean_at_rest), mean_(mean_at_rest) {}

  double commit(const PlaneStrain& strain) final;
  const ShearCycles& cycles() const { return cycles_; }
  double mean_at_rest() const { return mean_at_rest_; }  ///< Pa
  double mean() const { return mean_; }                  ///< mean effective stress at the last commit (Pa)
  double least_mean() const { return least_mean_; }      ///< the least of all commits (Pa)
  double taken() const { return taken_; }                ///< dissipated by compaction so far (J/m3)

 protected:
  /// Of the law of stress alone.
  virtual double commit_shear(const PlaneStrain& strain) = 0;
  /// eps_v has grown by that: returns what the store has lost (J/m3).
  virtual double compact(double more) = 0;

 private:
  ShearCycles cycles_;
  double mean_at_rest_, least_mean_, mean_, taken_ = 0.;
};

/// Around a law that is elastic in volume, with its bulk modulus K (Pa); its strength does not know what compaction
/// takes.
std::unique_ptr<CompactingPoint> compacting_point(std::unique_ptr<SoilPoint> elastic_in_volume, double bulk_modulus,
                                                  const ShearCompaction& law, double mean_at_rest);
/// Its strength is that by the effective stress that is left. What the tip of its planes takes as plastic strain does
/// not come back when it is pressed again.
std::unique_ptr<CompactingPoint> compacting_point(std::shared_ptr<const MohrCoulombLaw> soil,
                                                  const PlaneStress& at_rest, double bulk_modulus,
                                                  const ShearCompaction& law);

}  // namespace upbead
