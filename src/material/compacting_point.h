// A point of soil that compacts under cycles of shear, whichever law its shear stress follows.
#pragma once

#include <memory>

#include "material/densification.h"
#include "material/soil_point.h"

namespace upbead {

/// Compaction eps_v is an eigenstrain: if the soil cannot shrink, its mean effective stress falls by K eps_v, in all
/// directions. The stress falls no lower than zero; the rest of eps_v waits until the grains press again. Compaction
/// acts at commits and is constant within a step. The energy that it takes from the store at a given strain is
/// dissipated, 0 or more.
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
  /// Commits the law of stress alone; returns its dissipation (J/m3).
  virtual double commit_shear(const PlaneStrain& strain) = 0;
  /// Adds `more` to eps_v; returns the energy that the store loses (J/m3).
  virtual double compact(double more) = 0;

 private:
  ShearCycles cycles_;
  double mean_at_rest_, least_mean_, mean_, taken_ = 0.;
};

/// A point around a law that is elastic in volume, with its bulk modulus K (Pa). Its strength does not depend on the
/// mean stress that compaction removes.
std::unique_ptr<CompactingPoint> compacting_point(std::unique_ptr<SoilPoint> elastic_in_volume, double bulk_modulus,
                                                  const ShearCompaction& law, double mean_at_rest);
/// A point whose strength follows the effective stress that is left. Plastic strain at the apex of its planes is not
/// recovered when the soil is compressed again.
std::unique_ptr<CompactingPoint> compacting_point(std::shared_ptr<const MohrCoulombLaw> soil,
                                                  const PlaneStress& at_rest, double bulk_modulus,
                                                  const ShearCompaction& law);

}  // namespace upbead
