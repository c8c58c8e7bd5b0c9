#include "reliability/ground.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <filesystem>
#include <variant>

#include "base/text.h"
#include "design/design.h"
#include "design/expected_laws.h"
#include "upbead/input/document.h"
#include "upbead/sliding/block.h"

namespace upbead {

namespace {

constexpr std::size_t most_kept = 256;  // soils: more than a gradient or a matrix of second derivatives goes through

/// The largest value, by the parabola through the largest sample and its neighbours: a sample's own value has a kink
/// where the next one becomes the largest.
double smooth_peak(const std::vector<double>& y) {
  const auto i = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
  if (i == 0 || i + 1 == y.size()) return y[i];
  const double slope = 0.5 * (y[i + 1] - y[i - 1]), curvature = y[i + 1] - 2. * y[i] + y[i - 1];
  return curvature < 0. ? y[i] - 0.5 * slope * slope / curvature : y[i];
}

/// S by slide() falls as the resistance R grows; the R with which it is `limit`, between still water's push, below
/// which nothing holds, and the largest force, above which nothing slides.
double resistance_of(double limit, double mass, const History& force, double push) {
  const double most = *std::max_element(force.value.begin(), force.value.end());
  const auto excess = [&](double R) { return slide(mass, force, R).residual - limit; };
  const double least = std::max(push, 0.), room = most - least;
  if (room <= 0.) return most;
  double high = most, low = most;
  for (int step = 1; step < 40; ++step) {
    low = least + room * std::pow(0.8, step);
    if (excess(low) > 0.) break;
    high = low;
  }
  if (high == low) return least;
  boost::uintmax_t steps = 60;
  const auto found =
      boost::math::tools::toms748_solve(excess, low, high, boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (found.first + found.second);
}

SeaState sea_of(const DesignWave& wave) {
  return {wave.significant_height, wave.period, 1., wave.angle, 0.};
}

ImpactWave impact_of(const WaveForces& forces, const ImpactAssumptions& impact, const GroundWave& asked) {
  const double H = asked.wave.height;
  const WaveFactors uplift{1., asked.factors.uplift};
  return impact_wave(impact,
                     wave_on_wall(H, asked.wave.period, forces.at(H, uplift, PressureFormula::standing),
                                  forces.at(H, uplift), breaker_of(impact, asked.section, forces.wavelength())),
                     forces.breakwater().water, asked.section.berm_depth);
}

/// Why a variable reaches soils that the model does not answer; "" where it does not.
std::string beyond(const RandomVariable& v, const SoilAxis& axis) {
  if (v.low && v.high && *v.low >= axis.low && *v.high <= axis.high) return "";
  return "a soil beyond the box of the model has no answer, and the variable is not cut by low and high within " +
         significant(axis.low, 6) + " and " + significant(axis.high, 6);
}

void check_soil_variables(const DesignTables& tables, const ModelledGround& ground, const Document& document,
                          Diagnostics& report) {
  const std::vector<SoilAxis> box = ground.box();
  for (const auto& [name, variable] : tables.reliability->variables) {
    const std::string path = dotted("reliability.variables", name);
    if (!is_of_soil(variable.acts_on) || !report.sound(path)) continue;
    const auto axis = std::find_if(
        box.begin(), box.end(), [key = &variable.acts_on](const SoilAxis& one) { return is_same_key(one.key, *key); });
    if (axis == box.end()) continue;  // check_reliability() finds no such number
    if (const std::string why = beyond(variable, *axis); !why.empty())
      report.add(document.place(dotted(path, "high")), "[" + path + "]: " + why,
                 "cut it there, or make the model with a wider box");
  }
}

}  // namespace

bool is_of_soil(const std::string& acts_on) {
  return acts_on.rfind("regions.", 0) == 0;
}

bool asks_for_ground(const DesignTables& tables) {
  if (!tables.reliability) return false;
  const auto& variables = tables.reliability->variables;
  return tables.reliability->dynamics || std::any_of(variables.begin(), variables.end(),
                                                     [](const auto& one) { return is_of_soil(one.second.acts_on); });
}

ModelledGround::ModelledGround(const DesignTables& tables, const std::string& file, const Place& place)
    : table_(*tables.dynamics),
      certain_{tables.section, tables.water, tables.duration, tables.combined},
      impact_(tables.impact),
      place_(place),
      soil_(tables.dynamics->soil) {
  auto read = read_any_model_file(file);
  if (auto* one = std::get_if<ReducedModelFile>(&read)) {
    if (!soil_.empty()) throw InputError(place, "the model '" + file + "' has one soil", "remove 'soil'");
    tell(*one);
  } else {
    soils_.emplace(std::move(std::get<SoilModelFile>(read)), file);
    tell(of_soil(*soils_, soil_, place));
  }
  knows_base_ = !kept_.begin()->second.shear.base.empty();
}

void ModelledGround::tell(const ReducedModelFile& file) {
  kept_[soil()] = held_of(file);
  warnings_ = wave_model(file, table_, certain_.section, certain_.water, place_).warnings;
}

ModelledGround::Held ModelledGround::held_of(const ReducedModelFile& file) const {
  return {wave_model(file, table_, certain_.section, certain_.water, place_).shear,
          file.nested ? std::make_shared<const NestedModels>(*file.nested) : nullptr};
}

const ModelledGround::Held& ModelledGround::held(const Soil& soil) {
  const auto found = kept_.find(soil);
  if (found != kept_.end()) return found->second;
  if (kept_.size() >= most_kept) kept_.clear();
  return kept_[soil] = held_of(soils_->at(soils_->whole(soil)));
}

Breakwater ModelledGround::breakwater_of(const GroundWave& asked) const {
  Breakwater breakwater = certain_;
  breakwater.section = asked.section;
  breakwater.water = asked.water;
  return breakwater;
}

double ModelledGround::step_of(const Breakwater& breakwater, const GroundWave& asked) const {
  return table_.step.value_or(impact_of(WaveForces(breakwater, sea_of(asked.wave)), impact_, asked).rise /
                              steps_of_a_rise);
}

GroundPoint ModelledGround::at(const GroundWave& asked) {
  const Breakwater breakwater = breakwater_of(asked);
  const SeaState sea = sea_of(asked.wave);
  // a part of each wave's own rise, so that its peak is a sample: else it would move with the rise from sample to
  // sample
  const double step = step_of(breakwater, asked);
  const DynamicLaw law(breakwater, sea, impact_, std::make_shared<const ShearAnswer>(held(asked.soil).shear, step, 0.));
  const DynamicWave wave = law.wave(asked.wave.height, asked.factors);
  const Section& s = asked.section;
  const StillWater& still = law.forces()->still();
  History force{wave.time, wave.sliding_force};
  const double push = std::max(still.push, 0.);  // counted where it acts with the wave, as by formulas
  for (double& F : force.value) F += push;
  GroundPoint out;
  out.resistance = s.friction * (s.submerged_weight + still.weight);
  out.force = smooth_peak(force.value);
  if (asked.sliding) out.holding = resistance_of(*asked.sliding, s.weight / breakwater.water.gravity, force, push);
  out.base = law.base(asked.wave.height, asked.factors);
  return out;
}

std::optional<double> ModelledGround::error(const GroundWave& asked) {
  const Held& soil = held(asked.soil);
  if (!soil.nested) return {};
  const Breakwater breakwater = breakwater_of(asked);
  const double step = step_of(breakwater, asked);
  const auto answer = [&](const ModalModel& modes) {
    ShearModel model = soil.shear;
    model.modes = modes;
    model.shear = 0;
    model.base.clear();
    model.circles.reset();
    const DynamicLaw law(breakwater, sea_of(asked.wave), impact_, std::make_shared<const ShearAnswer>(model, step, 0.));
    const DynamicWave wave = law.wave(asked.wave.height, asked.factors);
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(wave.shear.data(), static_cast<Eigen::Index>(wave.shear.size())));
  };
  const Eigen::VectorXd all = answer(soil.nested->reference), fewer = answer(soil.nested->middle);
  return soil.nested->safety * (all - fewer).cwiseAbs().maxCoeff() / all.cwiseAbs().maxCoeff();
}

void check_ground(DesignTables& tables, const Document& document, Diagnostics& report) {
  if (!asks_for_ground(tables) || !report.sound("reliability")) return;
  if (!tables.sea && !tables.storms) check_impact(tables, document, report);  // else check_expected() does
  if (!tables.dynamics) {
    if (report.sound("dynamics"))
      report.add(document.place("reliability"), "[reliability]: there is no ground whose soil could be random",
                 "add [dynamics] with model = the path of a model of soils, made by 'upbead reduce --soils'");
    return;
  }
  if (!report.sound("dynamics") || !report.sound("section") || !report.sound("fluid")) return;
  const Place place = document.place("dynamics.model");
  const std::filesystem::path file = std::filesystem::path(document.path()).parent_path() / tables.dynamics->model;
  try {
    const ModelledGround ground(tables, file.lexically_normal().string(), place);
    tables.dynamics->soil = ground.soil();
    check_soil_variables(tables, ground, document, report);
  } catch (const InputError& error) {
    if (tables.sea || tables.storms) return;  // check_expected() tells it
    for (const Diagnostic& mistake : error.diagnostics())
      report.add(mistake.place.line > 0 ? mistake.place : place, mistake.what, mistake.cure);
  }
}

}  // namespace upbead
