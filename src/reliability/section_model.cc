#include "reliability/section_model.h"

#include <algorithm>

namespace upbead {

namespace {

/// A wave lower than this is none; random heights may be (m).
constexpr double least_height = 1e-3;

}  // namespace

SectionModel::SectionModel(const DesignTables& tables, AskGround ground)
    : tables_(tables), wave_(random_wave(tables)), ground_(std::move(ground)) {
  for (const RandomFactor& factor : random_factors) factors_.push_back(factor.certain);
  for (const auto& [name, variable] : tables_.reliability->variables) {
    const RandomFactor* factor = find_factor(variable.acts_on);
    targets_.push_back(factor ? &factors_[static_cast<std::size_t>(factor - random_factors.data())]
                              : number_at(tables_, variable.acts_on));
    certain_.push_back(*targets_.back());
  }
}

SectionPoint SectionModel::at(const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) *targets_[i] = x[i];
  const auto factor = [this](const char* name) {
    return factors_[static_cast<std::size_t>(find_factor(name) - random_factors.data())];
  };
  const Section level = at_water_level(tables_.section, tables_.water, factor("water_level"));
  SectionPoint out;
  out.section = with_factors(level, {1., 1., factor("friction"), factor("weight")});
  out.still = still_water(out.section, tables_.water);
  WaveGiven given = tables_.waves.at(wave_);
  given.period = std::max(given.period * factor("period"), least_height);
  for (std::optional<double>* height : {&given.height, &given.significant_height, &given.deep_water_height})
    if (*height) **height = std::max(**height * factor("significant_height"), least_height);
  DesignWave wave = design_wave(given, out.section, tables_.water);
  wave.height = std::max(wave.height * factor("wave"), least_height);
  out.pressure = Goda(out.section, tables_.water, wave).at(wave.height);
  out.pressure.force *= factor("force");
  out.pressure.force_moment *= factor("force");
  out.pressure.uplift *= factor("uplift");
  out.pressure.uplift_moment *= factor("uplift");
  out.load = sliding_load(out.section, tables_.water, out.pressure, wave.height, wave.period, tables_.duration);
  out.limits = tables_.limits;
  out.height = wave.height;
  out.force_factor = factor("force");
  out.sliding_factor = factor("sliding");
  if (ground_) ask_ground(x, factor("uplift"), wave, out);
  return out;
}

/// All limit states and methods ask for the same points, whose answers are kept.
void SectionModel::ask_ground(const std::vector<double>& x, double uplift, const DesignWave& wave, SectionPoint& out) {
  constexpr std::size_t most_answers = 1000000;
  out.wave = {out.section, tables_.water, wave, {out.force_factor, uplift}, tables_.dynamics->soil, out.limits.sliding};
  if (out.wave.sliding) *out.wave.sliding /= std::max(out.sliding_factor, 1e-12);
  out.ground = [this, x, asked = out.wave]() -> const GroundPoint& {
    const auto found = answered_.find(x);
    if (found != answered_.end()) return found->second;
    if (answered_.size() >= most_answers) answered_.clear();
    try {
      return answered_[x] = ground_(asked);
    } catch (const NumericsError& error) {
      if (n_unanswered_++ == 0) why_unanswered_ = error.what();
      GroundPoint none;
      none.why_not = error.what();
      return answered_[x] = none;
    }
  };
}

}  // namespace upbead
