#include "case/key_units.h"

#include <algorithm>
#include <cmath>

#include "model/quantities.h"

namespace upbead {

namespace {

/// A key, "*" for any name, and what its number is.
struct KeyQuantity {
  const char* pattern;
  const Quantity* quantity;
};

namespace q = quantities;
const std::vector<KeyQuantity> key_quantities{
    {"loads.*.pulse.duration", &q::load_duration},
    {"loads.*.pulse.plateau_duration", &q::load_duration},
    {"loads.*.pulse.frequency", &q::frequency},
    {"loads.*.wave.height", &q::wave_height},
    {"loads.*.wave.significant_height", &q::wave_height},
    {"loads.*.wave.deep_water_height", &q::wave_height},
    {"loads.*.wave.period", &q::wave_period},
    {"loads.*.wave.angle", &q::wave_angle},
    {"loads.*.train.height", &q::wave_height},
    {"loads.*.train.depth", &q::depth},
    {"loads.*.train.period", &q::wave_period},
    {"regions.*.damping.frequencies", &q::frequency},
    {"sliding.wave.height", &q::wave_height},
    {"sliding.wave.depth", &q::depth},
    {"sliding.wave.period", &q::wave_period},
    {"cycles.run_height", &q::wave_height},
    {"cycles.height", &q::wave_height},
    {"cycles.period", &q::wave_period},
    {"cycles.duration", &q::storm_duration},
    {"regions.*.cyclic.alpha", &q::cyclic_resistance},
    {"initial.k0", &q::rest_coefficient},
    {"mesh.parameters.mound_slope", &q::slope},
    {"limits.sliding", &q::sliding_limit},
    {"limits.base_pressure", &q::pressure_limit},
    {"limits.dynamic_base_pressure", &q::pressure_limit},
    {"limits.settlement", &q::settlement_limit},
    {"limits.tilt", &q::tilt_limit},
    {"limits.overturning", &q::safety_limit},
    {"limits.sliding_factor", &q::safety_limit},
    {"limits.seaward_sliding_factor", &q::safety_limit},
    {"limits.circles", &q::strength_limit},
    {"limits.safety", &q::strength_limit},
    {"limits.peak_safety", &q::strength_limit},
    {"limits.liquefaction", &q::strength_limit},
    {"limits.pressure_ratio", &q::ratio_limit},
    {"limits.lives_beyond", &q::ratio_limit},
    {"section.water_depth", &q::depth},
    {"section.foundation_depth", &q::depth},
    {"section.berm_depth", &q::depth},
    {"section.crest", &q::depth},
    {"section.width", &q::depth},
    {"section.centroid", &q::depth},
    {"section.berm_width", &q::depth},
    {"section.harbour_level", &q::level},
    {"section.bed_slope", &q::bed_slope},
    {"section.friction", &q::friction},
    {"section.lambda_1", &q::pressure_factor},
    {"section.lambda_2", &q::pressure_factor},
    {"section.lambda_3", &q::pressure_factor},
    {"waves.*.height", &q::wave_height},
    {"waves.*.significant_height", &q::wave_height},
    {"waves.*.deep_water_height", &q::wave_height},
    {"waves.*.period", &q::wave_period},
    {"waves.*.angle", &q::wave_angle},
    {"waves.*.pulse_duration", &q::load_duration},
    {"waves.*.shear_to_force_ratio", &q::shear_ratio},
    {"levels.*", &q::level},
    {"ground.stiffness", &q::stiffness},
    {"sea.heights.*", &q::wave_height},
    {"storms.location", &q::wave_height},
    {"storms.scale", &q::wave_height},
    {"storms.duration", &q::storm_duration},
    {"storms.period", &q::wave_period},
    {"storms.angle", &q::wave_angle},
    {"storms.tide_low", &q::level},
    {"storms.tide_high", &q::level},
    {"calibration.period", &q::wave_period},
};

bool fits(const std::vector<std::string>& path, const std::vector<std::string>& pattern) {
  return std::equal(path.begin(), path.end(), pattern.begin(), pattern.end(),
                    [](const std::string& part, const std::string& of) { return of == "*" || of == part; });
}

/// A load in consolidation lasts as long as it likes, as tides and fills do.
bool is_slow(const Document& document, const std::string& path) {
  const Node* inertia = document.find("time.inertia");
  const bool* counts = inertia ? std::get_if<bool>(&inertia->value) : nullptr;
  return counts && !*counts && path.find("duration") != std::string::npos;
}

void judge_level(const std::string& path, double value, NumberedWarnings& list) {
  if (auto warning = implausible(path, std::abs(value), quantities::level)) {
    warning->value = value;
    list.push_back(std::move(*warning));
  }
}

}  // namespace

NumberedWarnings implausible_keys(const Document& document, const std::function<void(const NumberVisitor&)>& visit) {
  NumberedWarnings list;
  visit([&](const KeyInfo&, const std::string& path, double& number) {
    const std::vector<std::string> parts = split_dotted(path);
    const auto of = std::find_if(key_quantities.begin(), key_quantities.end(),
                                 [&](const KeyQuantity& key) { return fits(parts, split_dotted(key.pattern)); });
    if (of == key_quantities.end() || !document.find(path) || is_slow(document, path)) return;
    if (of->quantity == &quantities::level) return judge_level(path, number, list);
    judge(path, number, *of->quantity, list);
  });
  return list;
}

NumberedWarnings implausible_section(const Section& section, const Water& water) {
  NumberedWarnings list;
  const double scale = water.gravity / 9.81, least_gravity = quantities::gravity.low;
  constexpr double deepest = 120.;  // m, of a prototype; of a model in a centrifuge its depth times gravity / g
  if (water.gravity < least_gravity || (section.water_depth <= deepest && scale * section.water_depth > deepest)) {
    Quantity earth = quantities::gravity;
    earth.high = 9.81;
    judge("gravity", water.gravity, earth, list);
  }
  const double unit_weight = water.density * water.gravity;
  const double whole = unit_weight * section.width * (section.foundation_depth + section.crest);
  const auto weight = [&](const std::string& key, double value, const Range& ever, const Range& common) {
    judge(key, value,
          {"N/m",
           ever.low() * whole,
           ever.high() * whole,
           common.low() * whole,
           common.high() * whole,
           {{"kN/m", 1e3}, {"MN/m", 1e6}, {"t/m", 9.81e3}, {"kg/m", 9.81}},
           "beside water of the caisson's size"},
          list);
  };
  weight("section.weight", section.weight, from_to(0.1, 10.), from_to(0.5, 3.));
  weight("section.submerged_weight", section.submerged_weight, from_to(0.02, 10.), from_to(0.25, 2.5));
  return list;
}

}  // namespace upbead
