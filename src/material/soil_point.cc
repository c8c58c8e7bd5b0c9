#include "material/soil_point.h"

#include <utility>

namespace upbead {

namespace {

template <class Law>
class PointOf : public SoilPoint {
 public:
  PointOf(std::shared_ptr<const Law> law, typename Law::State at_rest)
      : law_(std::move(law)), now_(std::move(at_rest)) {
    rest_ = now_stress_ = law_->update({}, now_).stress;
    stored_at_rest_ = law_->stored(now_);
  }
  PlaneStress stress(const PlaneStrain& strain) override {
    scratch_ = now_;
    return since_rest(law_->update(strain, scratch_).stress);
  }
  double commit(const PlaneStrain& strain) override {
    const LawAnswer answer = law_->update(strain, now_);
    now_stress_ = answer.stress;
    return answer.dissipated;
  }
  double stored() const override {
    const PlaneStrain& e = now_.strain;
    return law_->stored(now_) - stored_at_rest_ - (rest_.xx * e.xx + rest_.yy * e.yy + 2. * rest_.xy * e.xy);
  }
  PlaneStress borne() const override { return since_rest(now_stress_); }
  double mobilised() const override { return law_->mobilised(now_stress_); }

 private:
  PlaneStress since_rest(const PlaneStress& s) const {
    return {s.xx - rest_.xx, s.yy - rest_.yy, s.xy - rest_.xy, s.zz - rest_.zz};
  }

  std::shared_ptr<const Law> law_;
  typename Law::State now_, scratch_;
  PlaneStress rest_, now_stress_;
  double stored_at_rest_ = 0.;
};

}  // namespace

std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const HystereticLaw> law, HystereticLaw::State at_rest) {
  return std::make_unique<PointOf<HystereticLaw>>(std::move(law), std::move(at_rest));
}

std::unique_ptr<SoilPoint> soil_point(std::shared_ptr<const MohrCoulombLaw> law, const PlaneStress& at_rest) {
  return std::make_unique<PointOf<MohrCoulombLaw>>(std::move(law), MohrCoulombLaw::State{at_rest, {}});
}

}  // namespace upbead
