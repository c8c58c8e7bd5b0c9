#include "upbead/expected/sliding_law.h"

#include <algorithm>
#include <stdexcept>

#include "upbead/sliding/combined.h"
#include "upbead/sliding/wave_sliding.h"

namespace upbead {

namespace {

/// Laws that know a pulse of F_S.
class PulseLaw : public SlidingLaw {
 public:
  PulseLaw(Law law, const Breakwater& breakwater, const SeaState& state) : law_(law), forces_(breakwater, state) {}

  double threshold(const WaveFactors& factors) const override { return forces_.threshold(most(factors)); }

  bool may_slide(double height, const WaveFactors& factors) const override {
    return forces_.excess(height, most(factors)) > 0.;
  }

  double distance(double height, const WaveFactors& factors) const override {
    const Section section = with_factors(forces_.breakwater().section, factors);
    const WavePressure pressure = forces_.at(height, factors);
    const double resistance = section.friction * section.buoyant_weight;
    if (pressure.force + section.friction * uplift_gain() * pressure.uplift <= resistance)
      return 0.;  // most waves: spared the rest
    if (resistance <= 0.) throw std::invalid_argument("the caisson floats: its buoyant weight is not above 0");
    const SlidingLoad load =
        sliding_load(section, forces_.breakwater().water, pressure, height, forces_.period(), forces_.breakwater().k);
    if (law_ == Law::paper) return sliding_distance_paper(load.mass, load.resistance, load.pulse);
    if (law_ == Law::exact) return sliding_distance_exact(load.mass, load.resistance, load.pulse);
    return combined(section, pressure, load, height, factors);
  }

 private:
  /// How much larger than U_max the uplift may be at some time.
  double uplift_gain() const {
    const CombinedModel& model = forces_.breakwater().combined;
    return law_ == Law::combined && model.uplift == UpliftShape::sinusoidal ? std::max(model.uplift_gain, 1.) : 1.;
  }

  WaveFactors most(WaveFactors factors) const {
    factors.uplift *= uplift_gain();
    return factors;
  }

  double combined(const Section& section, const WavePressure& pressure, const SlidingLoad& load, double height,
                  const WaveFactors& factors) const {
    const double standing = forces_.at(height, factors, PressureFormula::standing).force;
    const CombinedWave wave{forces_.period(), standing, {pressure.force, load.pulse.duration}, pressure.uplift};
    const CombinedModel& model = forces_.breakwater().combined;
    const double mass = load.mass + added_mass(forces_.breakwater().water.density, section.foundation_depth, model);
    return std::max(sliding_distance_combined(mass, load.resistance, section.friction, wave, model), 0.);
  }

  Law law_;
  WaveForces forces_;
};

}  // namespace

const char* word(Law law) {
  switch (law) {
    case Law::paper:
      return "paper";
    case Law::exact:
      return "exact";
    case Law::combined:
      return "combined";
    case Law::dynamic:
      break;
  }
  return "dynamic";
}

std::unique_ptr<SlidingLaw> formula_law(Law law, const Breakwater& breakwater, const SeaState& state) {
  if (law == Law::dynamic) throw std::invalid_argument("the law dynamic needs a reduced model");
  return std::make_unique<PulseLaw>(law, breakwater, state);
}

}  // namespace upbead
