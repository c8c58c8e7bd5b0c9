#include "design/expected_laws.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <variant>

#include "base/text.h"
#include "case/strain_model.h"
#include "design/model_section.h"
#include "dynamics/answer_error.h"
#include "fem/caisson/reading_names.h"
#include "model/quantities.h"
#include "upbead/output/model_file.h"

namespace upbead {

namespace {

constexpr double mass_tolerance = 0.01;

bool has(const ModalModel& modes, const std::string& name) {
  return std::any_of(modes.reading_label.begin(), modes.reading_label.end(),
                     [&name](const ReadingLabel& label) { return label.name == name; });
}

/// P per unit of each load (N/m).
Eigen::RowVectorXd forces(const ModalModel& modes) {
  return modes.feedthrough.row(modes.index(reading::force));
}

/// The load of that name, else the one with the largest force; -1 where there is none.
int load_of(const ReducedModelFile& file, const std::string& name) {
  if (!name.empty()) {
    const auto& names = file.modes.load_name;
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  }
  int best = -1;
  double largest = 0.;
  for (int k = 0; k < file.modes.n_loads(); ++k) {
    const double peak = std::abs(forces(file.modes)[k]) * file.loads[static_cast<std::size_t>(k)].peak;
    if (peak > largest || best < 0) best = k;
    largest = std::max(largest, peak);
  }
  return best;
}

/// Warning load_left_out: the waves of a design act by one load of the model's case, and the others by none.
NumberedWarnings warnings_of_other_loads(const ReducedModelFile& file, int load) {
  std::vector<std::string> others;
  for (int k = 0; k < file.modes.n_loads(); ++k)
    if (k != load && file.loads[static_cast<std::size_t>(k)].peak > 0.)
      others.push_back(file.modes.load_name[static_cast<std::size_t>(k)]);
  if (others.empty()) return {};
  return {{"load_left_out", static_cast<double>(others.size()), 0., "1",
           "waves act by the load " + in_quotes(file.modes.load_name[static_cast<std::size_t>(load)]) +
               " of the model's case alone: " + join(others) + ", which acts there, too, is in no wave here",
           "count a weight in [section] weight and submerged_weight, an uplift by [impact]; reduce a case without the "
           "rest"}};
}

void check_mass(double mass, const Section& section, const Water& water, const Place& place, Diagnostics& mistakes) {
  const double weight = mass * water.gravity;
  if (std::abs(weight / section.weight - 1.) <= mass_tolerance) return;
  mistakes.add(place,
               "the caisson of the model weighs " + significant(weight, 5) +
                   " N/m, that of [section] weight = " + significant(section.weight, 5) + " N/m",
               "give one caisson in both, within 1 %");
}

void check_width(const std::optional<ModelBase>& base, const Section& section, const Place& place,
                 Diagnostics& mistakes) {
  if (!base || std::abs(base->width / section.width - 1.) <= mass_tolerance) return;
  mistakes.add(place,
               "the caisson of the model is " + significant(base->width, 5) +
                   " m wide, that of [section] width = " + significant(section.width, 5) + " m",
               "give one caisson in both, within 1 %");
}

/// Warning implausible of an arm at which no wave acts: the model's load hardly changes in a time long beside its own
/// periods, in which it is in balance with the ground.
NumberedWarnings arm_warnings(const ReducedModelFile& file, int load, const Section& section) {
  constexpr double slow = 0.01;  // 1/s
  if (!has(file.modes, reading::base_moment)) return {};
  const auto at = [&](const char* name) { return file.modes.transfer(file.modes.index(name), load, slow).real(); };
  const Quantity of_height{"1", 0.2, 0.9, 0.3, 0.7, {}};
  NumberedWarnings list;
  judge("the arm above the bottom of the load '" + file.modes.load_name[static_cast<std::size_t>(load)] +
            "' of the model",
        at(reading::base_moment) / at(reading::shear_force),
        of(of_height, section.foundation_depth + section.crest, "m", "a wave presses on the whole wall"), list);
  return list;
}

/// Slip circles of the model are in the ground between its own two levels of still water.
void check_still_water(const std::optional<StillWater>& of_model, const Section& section, const Water& water,
                       const Place& place, Diagnostics& mistakes) {
  const double model = of_model ? of_model->push : 0., own = still_water(section, water).push;
  if (std::abs(model - own) <= mass_tolerance * std::max(std::abs(model), std::abs(own))) return;
  mistakes.add(place,
               "still water pushes the caisson of the model with " + significant(model, 5) +
                   " N/m, that of [section] harbour_level = " + significant(section.harbour_level, 5) + " m with " +
                   significant(own, 5) + " N/m",
               "give [initial] harbour_level of the model's case and [section] harbour_level the same two levels");
}

constexpr double longer_by_scatter = 2.;  // bounds hold up to this multiple of the record's longest period

/// The shortest t_r of waves that might slide the caisson. The rise grows with the height; half the threshold of eq.
/// (7) is safely below the height at which sliding begins.
double shortest_rise(const Breakwater& breakwater, const ImpactAssumptions& impact,
                     const std::vector<SeaState>& record) {
  double shortest = HUGE_VAL;
  for (const SeaState& state : record) {
    const WaveForces forces(breakwater, state);
    const Section& section = forces.breakwater().section;
    const auto breaker = breaker_of(impact, section, forces.wavelength());
    const double threshold = forces.threshold({});
    const double slides = 0.5 * (std::isfinite(threshold) ? threshold : state.significant_height);
    const double height = std::max(slides, breaker.value_or(0.));  // an impact rises faster than what is lower
    const WavePressure standing = forces.at(height, {}, PressureFormula::standing);
    const ImpactWave wave =
        impact_wave(impact, wave_on_wall(height, state.period, standing, forces.at(height, {}), breaker),
                    breakwater.water, section.berm_depth);
    shortest = std::min(shortest, wave.rise);
  }
  return shortest;
}

}  // namespace

WaveModel read_wave_model(const std::string& path, const DynamicsTable& table, const Section& section,
                          const Water& water, const Place& place) {
  const auto file = read_any_model_file(path);
  if (const auto* one = std::get_if<ReducedModelFile>(&file)) {
    if (!table.soil.empty())
      throw InputError(place, "the model '" + path + "' has one soil",
                       "remove 'soil', or make it by 'upbead reduce --soils'");
    return wave_model(*one, table, section, water, place);
  }
  const SoilAnswers soils(std::get<SoilModelFile>(file), path);
  WaveModel model = wave_model(of_soil(soils, table.soil, place), table, section, water, place);
  model.shear.base.clear();  // lives by a model of soils were compared in S alone: docs/soils.md
  return model;
}

ReducedModelFile of_soil(const SoilAnswers& soils, const Soil& soil, const Place& place) {
  Diagnostics mistakes;
  try {
    return soils.at(soils.whole(soil));
  } catch (const InputError& error) {
    for (const Diagnostic& mistake : error.diagnostics()) mistakes.add(place, mistake.what, mistake.cure);
  }
  throw InputError(mistakes);
}

WaveModel wave_model(const ReducedModelFile& file, const DynamicsTable& table, const Section& section,
                     const Water& water, const Place& place) {
  Diagnostics mistakes;
  if (!has(file.modes, reading::force) || !has(file.modes, reading::shear_force) || file.caisson_mass <= 0.)
    throw InputError(place, "the model '" + table.model + "' has no caisson, so nothing can slide",
                     "reduce a case with a caisson");
  const int load = load_of(file, table.load);
  if (load < 0)
    mistakes.add(place, "the model has no load '" + table.load + "'",
                 suggestion(table.load, file.modes.load_name, "loads"));
  else if (forces(file.modes)[load] == 0.)
    mistakes.add(place,
                 "the load '" + file.modes.load_name[static_cast<std::size_t>(load)] +
                     "' of the model puts no horizontal force on the caisson",
                 "name another one as load");
  check_mass(file.caisson_mass, section, water, place, mistakes);
  check_width(file.base, section, place, mistakes);
  check_still_water(file.still, section, water, place, mistakes);
  mistakes.throw_if_any();
  WaveModel model{
      file.title,
      file.modes.load_name[static_cast<std::size_t>(load)],
      {file.modes, load, file.modes.index(reading::shear_force), forces(file.modes)[load], file.caisson_mass},
      file.warnings};
  append(model.warnings, warnings_of_other_loads(file, load));
  const std::vector<const char*> base{reading::normal_force, reading::base_moment, reading::uplift,
                                      reading::uplift_moment};
  if (std::all_of(base.begin(), base.end(), [&file](const char* name) { return has(file.modes, name); }))
    for (const char* name : base) model.shear.base.push_back(file.modes.index(name));
  append(model.warnings, arm_warnings(file, load, section));
  append(model.warnings, warnings_of_other_section(file, section, water));
  if (follows_strain(file))
    model.warnings.push_back(
        {"soil_of_other_wave", forces_of_case(file)[1], 0., "N/m",
         "the soil of the model follows its strain: all waves are answered with the stiffness that P = " +
             with_unit(forces_of_case(file)[1], "N/m") +
             " has left, though each leaves another, so that S of them may be wrong by far more than any error that is "
             "told",
         "judge S by the formulas, or solve the waves that slide the caisson by 'upbead run'", true});
  model.nested = file.nested;
  model.tolerance = file.tolerance;
  if (file.contact) model.nodes = std::make_shared<const ReducedModelFile>(file);
  if (file.circles) model.shear.circles = std::make_shared<const CircleModel>(*file.circles);
  return model;
}

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
  model_ = {model.title, model.load, table.step.value_or(rise / steps_of_a_rise), rise, model.warnings};
  of_file_ = std::make_shared<const WaveModel>(model);
  circles_ = model.shear.circles;
  nodes_ = model.nodes;
  load_ = model.shear.load;
  answer_ = std::make_shared<const ShearAnswer>(model.shear, model_->step, longer_by_scatter * longest);
}

std::unique_ptr<SlidingLaw> Laws::make(Law law, const SeaState& state) const {
  if (law == Law::dynamic) return dynamic(state);
  return formula_law(law, breakwater_, state);
}

std::unique_ptr<DynamicLaw> Laws::dynamic(const SeaState& state) const {
  return std::make_unique<DynamicLaw>(breakwater_, state, impact_, answer_);
}

std::vector<DearSlip> Laws::slips(const NodeAnswer& answer, const std::vector<SampledWave>& waves) const {
  std::vector<WaveOnBottom> on_bottom;
  for (const SampledWave& one : waves)
    on_bottom.push_back(dynamic(one.wave.sea)->on_bottom(one.wave.height, one.wave.factors));
  return answer(*nodes_, load_, on_bottom);
}

NumberedWarnings Laws::error_warnings(const SeaState& state, double height) const {
  if (!of_file_) return {};
  const WaveModel& model = *of_file_;
  if (!model.nested)
    return {{"no_error_estimate", 0., model.tolerance, "1",
             "the model of [dynamics] holds nothing from which the error of F_T follows",
             "make the model again with 'upbead reduce'"}};
  const DynamicWave wave = dynamic(state)->wave(height);
  const auto n = static_cast<Eigen::Index>(wave.force.size());
  WaveSamples loads = WaveSamples::Zero(static_cast<Eigen::Index>(model.shear.modes.load_name.size()), n);
  loads.row(model.shear.load) = Eigen::Map<const Eigen::RowVectorXd>(wave.force.data(), n) / model.shear.force_per_load;
  const double peak = Eigen::Map<const Eigen::RowVectorXd>(wave.shear.data(), n).cwiseAbs().maxCoeff();
  const ResponseError errors(model.shear.modes, model.shear.shear, *model.nested, model_->step, static_cast<int>(n), 1);
  const double error = peak > 0. ? errors.of(loads).bound() / peak : 0.;
  if (error <= model.tolerance) return {};
  return {{"reduced_model_error", error, model.tolerance, "1",
           "F_T of the highest wave, " + significant(height, 4) + " m, may be wrong by up to " +
               significant(100. * error, 2) + " % by the model of [dynamics] (tolerance " +
               significant(100. * model.tolerance) + " %)",
           "reduce again with a load as short as the impacts or a smaller [accuracy] tolerance, or march such a wave "
           "with 'upbead run'"}};
}

std::optional<WorstBase> Laws::base(Law law, const DrawnWave& wave) const {
  if (law == Law::dynamic) return dynamic(wave.sea)->base(wave.height, wave.factors);
  return WaveForces(breakwater_, wave.sea).base(wave.height, wave.factors);
}

std::string Laws::why_no_dynamic_base() const {
  if (!answer_) return "no [dynamics] gives a reduced model";
  return answer_->knows_base() ? "" : "the reduced model has no readings of the normal force and moment of the base";
}

WaysToFail Laws::ways(const DrawnWave& wave) const {
  return *dynamic(wave.sea)->ways(wave.height, wave.factors);
}

WaysToFail Laws::ways_at_rest() const {
  const SeaState calm{1., 10., 1., 0., 0.};
  const WaveForces forces(breakwater_, calm);
  const WorstBase base = forces.base(0., {});
  const Section& s = breakwater_.section;
  const StillWater& still = forces.still();
  const double weight_moment = s.submerged_weight * (0.5 * s.width - s.centroid.value_or(0.5 * s.width)) +
                               still.weight * s.width / 6. + still.push_moment;
  WaysToFail ways;
  ways.heel_pressure = base.heel_pressure;
  ways.toe_pressure = base.toe_pressure;
  const auto found =
      least_factor(*answer_->circles(), {s.submerged_weight + still.weight, still.push, weight_moment}, nullptr);
  if (found) ways.circles = found->factor;
  return ways;
}

std::vector<Law> Laws::known() const {
  std::vector<Law> list = all_laws;
  if (!answer_) list.pop_back();
  return list;
}

}  // namespace upbead
