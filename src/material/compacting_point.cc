#include "material/compacting_point.h"

#include <algorithm>
#include <utility>

namespace upbead {

namespace {

/// Without compaction, the mean stress (compression) would be that of the elastic soil, P_0 = P_rest - K eps. With
/// it, the mean stress P is P_0 - K eps_v where that is positive, 0 for P_0 from 0 to K eps_v, and P_0 where P_0 is
/// tension. P never falls as P_0 grows, and so has a potential in the strain.
class CompactingOverlay : public CompactingPoint {
 public:
  using CompactingPoint::CompactingPoint;

  void correct(const PlaneStrain& strain, PlaneStress& correction) const override {
    CompactingPoint::correct(strain, correction);
    const double less = std::clamp(mean_of(soil(), strain), 0., lost_);
    correction = difference(correction, {less, less, 0., less});
  }
  /// Less (1/K) times the integral of clamp(P, 0, K eps_v) from 0 to P_0.
  void stored_beside_elastic(const PlaneStrain& strain, double& energy) const override {
    CompactingPoint::stored_beside_elastic(strain, energy);
    const double P = mean_of(soil(), strain), reached = std::clamp(P, 0., lost_);
    energy -= (0.5 * reached * reached + lost_ * std::max(P - lost_, 0.)) / bulk();
  }

 private:
  void lose(double more, const PlaneStrain& /*strain*/) override { lost_ += more; }

  double lost_ = 0.;  ///< K eps_v (Pa)
};

}  // namespace

CompactingPoint::CompactingPoint(std::unique_ptr<SoilPoint> soil, const ElasticLaw& elastic, const ShearCompaction& law,
                                 double mean_at_rest)
    : soil_(std::move(soil)),
      bulk_(bulk_modulus(elastic)),
      cycles_(law),
      mean_at_rest_(mean_at_rest),
      least_mean_(mean_at_rest),
      mean_(mean_at_rest) {}

void CompactingPoint::commit(const PlaneStrain& strain, double& dissipated) {
  soil_->commit(strain, dissipated);
  const double before = cycles_.compaction(), stored_before = stored(strain);
  cycles_.add(strain);
  lose(bulk_ * (cycles_.compaction() - before), strain);
  const double by_compaction = std::max(stored_before - stored(strain), 0.);  // negative only by rounding
  taken_ += by_compaction;
  mean_ = mean_of(*this, strain);
  least_mean_ = std::min(least_mean_, mean_);
  dissipated += by_compaction;
}

double CompactingPoint::mean_of(const SoilPoint& soil, const PlaneStrain& strain) const {
  PlaneStress correction;
  soil.correct(strain, correction);
  return mean_at_rest_ - bulk_ * (strain.xx + strain.yy) - mean_stress(correction);
}

double CompactingPoint::stored(const PlaneStrain& strain) const {
  double energy = 0.;
  stored_beside_elastic(strain, energy);
  return energy;
}

std::unique_ptr<CompactingPoint> compacting_point(std::unique_ptr<SoilPoint> elastic_in_volume,
                                                  const ElasticLaw& elastic, const ShearCompaction& law,
                                                  double mean_at_rest) {
  return std::make_unique<CompactingOverlay>(std::move(elastic_in_volume), elastic, law, mean_at_rest);
}

}  // namespace upbead
