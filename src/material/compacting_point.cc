#include "material/compacting_point.h"

#include <algorithm>
#include <utility>

namespace upbead {

namespace {

double compression(const PlaneStress& s) {
  return -(s.xx + s.yy + s.zz) / 3.;
}

PlaneStress with_mean(const PlaneStress& s, double more) {
  return {s.xx + more, s.yy + more, s.xy, s.zz + more};
}

/// Without compaction, the mean stress (compression) would be that of the elastic soil, P_0 = P_rest - K eps. With
/// it, the mean stress P is P_0 - K eps_v where that is positive, 0 for P_0 from 0 to K eps_v, and P_0 where P_0 is
/// tension. P never falls as P_0 grows, and so has a potential in the strain.
class CompactingOverlay : public CompactingPoint {
 public:
  CompactingOverlay(std::unique_ptr<SoilPoint> inner, double bulk_modulus, const ShearCompaction& law,
                    double mean_at_rest)
      : CompactingPoint(law, mean_at_rest), inner_(std::move(inner)), bulk_(bulk_modulus), pressed_(mean_at_rest) {}

  PlaneStress stress(const PlaneStrain& strain) override {
    const PlaneStress s = inner_->stress(strain);
    return with_mean(s, std::clamp(mean_at_rest() + compression(s), 0., lost_));
  }
  double stored() const override { return inner_->stored() + stored_beside(); }
  double mobilised(const PlaneStress& change) const override { return inner_->mobilised(change); }

 private:
  double commit_shear(const PlaneStrain& strain) override {
    pressed_ = mean_at_rest() + compression(inner_->stress(strain));
    return inner_->commit(strain);
  }
  double compact(double more) override {
    const double before = stored_beside();
    lost_ += bulk_ * more;
    return before - stored_beside();
  }
  /// -(1/K) integral of clamp(P, 0, K eps_v) from 0 to P_0.
  double stored_beside() const {
    const double reached = std::clamp(pressed_, 0., lost_);
    return -(0.5 * reached * reached + lost_ * std::max(pressed_ - lost_, 0.)) / bulk_;
  }

  std::unique_ptr<SoilPoint> inner_;
  double bulk_;
  double pressed_;    ///< P_0 at the committed strain (Pa)
  double lost_ = 0.;  ///< K eps_v (Pa)
};

/// `rest`: a stress within the strength of the law.
class CompactingMohrCoulomb : public CompactingPoint {
 public:
  CompactingMohrCoulomb(std::shared_ptr<const MohrCoulombLaw> soil, const PlaneStress& rest, double bulk_modulus,
                        const ShearCompaction& law)
      : CompactingPoint(law, compression(rest)),
        soil_(std::move(soil)),
        now_{rest, {}},
        bulk_(bulk_modulus),
        rest_(rest),
        stored_at_rest_(soil_->stored(now_)) {}

  PlaneStress stress(const PlaneStrain& strain) override {
    MohrCoulombLaw::State scratch = now_;
    const PlaneStress s = soil_->update(strain, scratch).stress;
    return {s.xx - rest_.xx, s.yy - rest_.yy, s.xy - rest_.xy, s.zz - rest_.zz};
  }
  double stored() const override {
    const PlaneStrain& e = now_.strain;
    return soil_->stored(now_) - stored_at_rest_ - (rest_.xx * e.xx + rest_.yy * e.yy + 2. * rest_.xy * e.xy);
  }
  double mobilised(const PlaneStress& change) const override { return soil_->mobilised(sum(rest_, change)); }

 private:
  double commit_shear(const PlaneStrain& strain) override { return soil_->update(strain, now_).dissipated; }
  double compact(double more) override {
    const double before = soil_->stored(now_);
    waiting_ += bulk_ * more;
    const double takes = std::clamp(compression(now_.stress), 0., waiting_);
    now_.stress = with_mean(now_.stress, takes);
    waiting_ -= takes;
    return before - soil_->stored(now_);
  }

  std::shared_ptr<const MohrCoulombLaw> soil_;
  MohrCoulombLaw::State now_;
  double bulk_;
  PlaneStress rest_;
  double stored_at_rest_;
  double waiting_ = 0.;  ///< the part of K eps_v for which no stress was left (Pa)
};

}  // namespace

double CompactingPoint::commit(const PlaneStrain& strain) {
  const double by_shear = commit_shear(strain), before = cycles_.compaction();
  cycles_.add(strain);
  const double by_compaction = std::max(compact(cycles_.compaction() - before), 0.);  // negative only by rounding
  taken_ += by_compaction;
  mean_ = mean_at_rest_ + compression(stress(strain));
  least_mean_ = std::min(least_mean_, mean_);
  return by_shear + by_compaction;
}

std::unique_ptr<CompactingPoint> compacting_point(std::unique_ptr<SoilPoint> elastic_in_volume, double bulk_modulus,
                                                  const ShearCompaction& law, double mean_at_rest) {
  return std::make_unique<CompactingOverlay>(std::move(elastic_in_volume), bulk_modulus, law, mean_at_rest);
}

std::unique_ptr<CompactingPoint> compacting_point(std::shared_ptr<const MohrCoulombLaw> soil,
                                                  const PlaneStress& at_rest, double bulk_modulus,
                                                  const ShearCompaction& law) {
  MohrCoulombLaw::State state{at_rest, {}};
  const PlaneStress borne = soil->update({}, state).stress;
  return std::make_unique<CompactingMohrCoulomb>(std::move(soil), borne, bulk_modulus, law);
}

}  // namespace upbead
