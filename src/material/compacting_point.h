// A point of soil that compacts under cycles of shear, whichever law its shear stress follows.
#pragma once

#include <memory>

#include "material/densification.h"
#include "material/soil.h"

namespace upbead {

/// Compaction eps_v is an eigenstrain: if the soil cannot shrink, its mean effective stress falls by K eps_v, in all
/// directions. The stress falls no lower than zero; the rest of eps_v waits until the grains press again. Compaction
/// acts at commits and is constant within a step. The energy that it takes from the store at a given strain is
/// dissipated, 0 or more.
class CompactingPoint : public SoilPoint {
 public:
  /// `mean_at_rest`: mean effective stress, compression positive (Pa).
  CompactingPoint(std::unique_ptr<SoilPoint> soil, const ElasticLaw& elastic, const ShearCompaction& law,
                  double mean_at_rest);

  void correct(const PlaneStrain& strain, PlaneStress& correction) const override {
    soil_->correct(strain, correction);
  }
  void commit(const PlaneStrain& strain, double& dissipated) final;
  void stored_beside_elastic(const PlaneStrain& strain, double& energy) const override {
    soil_->stored_beside_elastic(strain, energy);
  }
  double mobilised(int lane, const PlaneStress& change) const override { return soil_->mobilised(lane, change); }
  const ShearCycles& cycles() const { return cycles_; }
  double mean_at_rest() const { return mean_at_rest_; }  ///< Pa
  double mean() const { return mean_; }                  ///< mean effective stress at the last commit (Pa)
  double least_mean() const { return least_mean_; }      ///< the least of all commits (Pa)
  double taken() const { return taken_; }                ///< dissipated by compaction so far (J/m3)

 protected:
  /// Adds `more` to K eps_v (Pa), at the committed strain.
  virtual void lose(double more, const PlaneStrain& strain) = 0;
  /// Mean effective stress of this point, or of the one within, from the committed state (Pa).
  double mean_of(const SoilPoint& soil, const PlaneStrain& strain) const;
  const SoilPoint& soil() const { return *soil_; }
  double bulk() const { return bulk_; }  ///< K (Pa)

 private:
  double stored(const PlaneStrain& strain) const;

  std::unique_ptr<SoilPoint> soil_;
  double bulk_;
  ShearCycles cycles_;
  double mean_at_rest_, least_mean_, mean_, taken_ = 0.;
};

/// A point around soil that is elastic in volume, and whose strength does not depend on the mean stress that compaction
/// removes.
std::unique_ptr<CompactingPoint> compacting_point(std::unique_ptr<SoilPoint> elastic_in_volume,
                                                  const ElasticLaw& elastic, const ShearCompaction& law,
                                                  double mean_at_rest);

}  // namespace upbead
