#include "material/soil_point.h"

#include <type_traits>
#include <utility>

namespace upbead {

namespace {

/// Calls of_number for each number of a state, in a fixed order.
template <class State, class Visit>
void visit(State& state, const Visit& of_number) {
  const auto of_strain = [&](auto& strain) {
    for (auto* number : {&strain.xx, &strain.yy, &strain.xy}) of_number(*number);
  };
  of_strain(state.strain);
  if constexpr (std::is_same_v<std::remove_const_t<State>, HystereticLaw::State>) {
    for (auto& plastic : state.plastic) of_strain(plastic);
  } else {
    of_strain(state.stress);
    of_number(state.stress.zz);
  }
}

template <class Law>
class PointOf : public SoilPoint {
 public:
  PointOf(std::shared_ptr<const Law> law, typename Law::State at_rest) : soil_{std::move(law), std::move(at_rest), {}} {
    soil_.rest = soil_.law->update({}, soil_.now).stress;
    stored_at_rest_ = soil_.law->stored(soil_.now);
  }
  PlaneStress stress(const PlaneStrain& strain) override {
    scratch_ = soil_.now;
    return since_rest(soil_.law->update(strain, scratch_).stress);
  }
  double commit(const PlaneStrain& strain) override { return soil_.law->update(strain, soil_.now).dissipated; }
  double stored() const override {
    const PlaneStrain& e = soil_.now.strain;
    const PlaneStress& rest = soil_.rest;
    return soil_.law->stored(soil_.now) - stored_at_rest_ - (rest.xx * e.xx + rest.yy * e.yy + 2. * rest.xy * e.xy);
  }
  double mobilised(const PlaneStress& change) const override { return soil_.mobilised(change); }
  void remember(std::vector<double>& memory) const override {
    visit(soil_.now, [&](double number) { memory.push_back(number); });
  }
  const double* recall(const double* memory) override {
    visit(soil_.now, [&](double& number) { number = *memory++; });
    return memory;
  }
  const HystereticSoil* hysteretic() const override { return told<HystereticLaw>(); }
  const MohrCoulombSoil* mohr_coulomb() const override { return told<MohrCoulombLaw>(); }

 private:
  PlaneStress since_rest(const PlaneStress& s) const {
    const PlaneStress& rest = soil_.rest;
    return {s.xx - rest.xx, s.yy - rest.yy, s.xy - rest.xy, s.zz - rest.zz};
  }
  template <class Other>
  const SoilOf<Other>* told() const {
    if constexpr (std::is_same_v<Law, Other>)
      return &soil_;
    else
      return nullptr;
  }

  SoilOf<Law> soil_;
  typename Law::State scratch_;
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
