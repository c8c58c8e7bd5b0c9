#include "expected_laws.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "shear_model.h"

namespace upbead {

namespace {

constexpr double steps_of_a_rise = 80.;
constexpr double longer_by_scatter = 2.;  // how much longer than the record's a period may be drawn for bounds to hold

/// The shortest t_r of waves that might slide. The rise grows with the height; half the threshold of eq. (7) is safely
/// below where sliding begins.
double shortest_rise(const Breakwater& breakwater, const ImpactAssumptions& impact,
                     const std::vector<SeaState>& record) {
  double shortest = HUGE_VAL;
  for (const SeaState& state : record) {
    const WaveForces forces(breakwater, state);
    const double threshold = forces.threshold({});
    const double height = 0.5 * (std::isfinite(threshold) ? threshold : state.significant_height);
    const WavePressure standing = forces.at(height, {}, PressureFormula::standing);
    const ImpactWave wave =
        impact_wave(impact, {height, state.period, standing.force, standing.alpha_star, standing.uplift},
                    breakwater.water, forces.breakwater().section.berm_depth);
    shortest = std::min(shortest, wave.rise);
  }
  return shortest;
}

}  // namespace

StormClimate climate_of(const StormsTable& table) {
  StormClimate climate = table;
  climate.angle *= boost::math::constants::degree<double>();
  return climate;
}

std::vector<SeaState> typical_storms(const Design& design) {
  std::vector<SeaState> storms;
  for (const double u_height : {0.5, 0.9, 0.99, 0.999, 0.9999})
    for (const double u_tide : {0., 1.})
      storms.push_back(
          storm_on(design.tables.section, design.tables.water, climate_of(*design.tables.storms), u_height, u_tide));
  return storms;
}

Laws::Laws(const Design& design, const std::vector<SeaState>& record)
    : breakwater_{design.tables.section, design.tables.water, design.tables.duration, design.tables.combined},
      impact_(design.tables.impact) {
  if (design.tables.dynamics) read_model(design, record);
}

void Laws::read_model(const Design& design, const std::vector<SeaState>& record) {
  const DynamicsTable& table = *design.tables.dynamics;
  const WaveModel model = read_wave_model(design.resolve(table.model), table, breakwater_.section, breakwater_.water,
                                          design.document.place("dynamics.model"));
  const double rise = shortest_rise(breakwater_, impact_, record);
  double longest = 0.;
  for (const SeaState& state : record) longest = std::max(longest, 0.5 * state.period);
  model_ = {model.title, model.load, table.step.value_or(rise / steps_of_a_rise), rise};
  answer_ = std::make_shared<const ShearAnswer>(model.shear, model_->step, longer_by_scatter * longest);
}

std::unique_ptr<SlidingLaw> Laws::make(Law law, const SeaState& state) const {
  if (law == Law::dynamic) return dynamic(state);
  return formula_law(law, breakwater_, state);
}

std::unique_ptr<DynamicLaw> Laws::dynamic(const SeaState& state) const {
  return std::make_unique<DynamicLaw>(breakwater_, state, impact_, answer_);
}

std::vector<Law> Laws::known() const {
  std::vector<Law> list = all_laws;
  if (!answer_) list.pop_back();
  return list;
}

}  // namespace upbead
