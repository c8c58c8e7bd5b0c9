#include "expected/dynamic_law.h"

#include <algorithm>
#include <cmath>

#include "first_height.h"
#include "upbead/sliding/block.h"

namespace upbead {

DynamicLaw::DynamicLaw(const Breakwater& breakwater, const SeaState& state, const ImpactAssumptions& assumptions,
                       std::shared_ptr<const ShearAnswer> answer)
    : forces_(breakwater, state), assumptions_(assumptions), answer_(std::move(answer)) {}

ImpactWave DynamicLaw::on_wall(double height, const WaveFactors& factors) const {
  const WavePressure standing = forces_.at(height, factors, PressureFormula::standing);
  const Breakwater& breakwater = forces_.breakwater();
  // The factor of P scales the history; its rise and duration are those of the wave without it.
  ImpactWave wave = impact_wave(
      assumptions_, {height, forces_.period(), standing.force / factors.force, standing.alpha_star, standing.uplift},
      breakwater.water, breakwater.section.berm_depth);
  wave.peak *= factors.force;
  wave.standing_force *= factors.force;
  return wave;
}

double DynamicLaw::most(const ImpactWave& wave, const Section& section) const {
  const double F = answer_->bound(limits(wave), number_of_samples(wave, answer_->step()));
  return F + section.friction * (wave.uplift - section.buoyant_weight);
}

bool DynamicLaw::may_slide(double height, const WaveFactors& factors) const {
  return most(on_wall(height, factors), with_factors(forces_.breakwater().section, factors)) > 0.;
}

double DynamicLaw::threshold(const WaveFactors& factors) const {
  const Section section = with_factors(forces_.breakwater().section, factors);
  return detail::first_height([&](double height) { return most(on_wall(height, factors), section); });
}

namespace {

void answer(const ShearAnswer& model, const ImpactAssumptions& assumptions, const Section& section, DynamicWave& out) {
  const int n = number_of_samples(out.wave, model.step());
  const auto size = static_cast<std::size_t>(n);
  out.force.resize(size);
  out.shear.resize(size);
  out.sliding_force.resize(size);
  sample_force(out.wave, model.step(), n, out.force.data());
  model.respond(out.force.data(), n, out.shear.data());
  sample_uplift(out.wave, assumptions.uplift, model.step(), n, out.force.data(), out.sliding_force.data());
  for (std::size_t i = 0; i < size; ++i) out.sliding_force[i] = out.shear[i] + section.friction * out.sliding_force[i];
}

}  // namespace

double DynamicLaw::slide_under(const DynamicWave& out, const Section& section) const {
  const double resistance = section.friction * section.buoyant_weight;
  const std::vector<double>& F = out.sliding_force;
  const auto start = std::find_if(F.begin(), F.end(), [resistance](double f) { return std::abs(f) > resistance; });
  if (start == F.end()) return 0.;
  const auto rest = std::max<std::ptrdiff_t>(start - F.begin() - 1, 0);
  ForceHistory history;
  history.value.assign(F.begin() + rest, F.end());
  for (std::size_t i = 0; i < history.value.size(); ++i)
    history.time.push_back((static_cast<double>(rest) + static_cast<double>(i)) * answer_->step());
  return slide(section.weight / forces_.breakwater().water.gravity, history, resistance).residual;
}

double DynamicLaw::distance(double height, const WaveFactors& factors) const {
  const Section section = with_factors(forces_.breakwater().section, factors);
  DynamicWave out;
  out.wave = on_wall(height, factors);
  if (most(out.wave, section) <= 0.) return 0.;
  answer(*answer_, assumptions_, section, out);
  return std::max(slide_under(out, section), 0.);
}

DynamicWave DynamicLaw::wave(double height, const WaveFactors& factors) const {
  const Section section = with_factors(forces_.breakwater().section, factors);
  DynamicWave out;
  out.wave = on_wall(height, factors);
  answer(*answer_, assumptions_, section, out);
  for (std::size_t i = 0; i < out.force.size(); ++i) out.time.push_back(static_cast<double>(i) * answer_->step());
  out.sliding = slide_under(out, section);
  return out;
}

}  // namespace upbead
