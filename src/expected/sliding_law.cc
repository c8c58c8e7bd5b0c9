#include "upbead/expected/sliding_law.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/numbers.h"
#include "upbead/sliding/combined.h"
#include "upbead/sliding/pulse.h"

namespace upbead {

namespace {

/// The laws that compute S from a pulse of F_S.
class PulseLaw : public SlidingLaw {
 public:
  PulseLaw(Law law, const Breakwater& breakwater, const SeaState& state) : law_(law), forces_(breakwater, state) {}

  double threshold(const WaveFactors& factors) const override { return forces_.threshold(most(factors)); }
  const WaveForces* forces() const override { return &forces_; }

  bool may_slide(double height, const WaveFactors& factors) const override {
    return forces_.excess(height, most(factors)) > 0.;
  }

  double distance(double height, const WaveFactors& factors) const override {
    const Section section = with_factors(forces_.breakwater().section, factors);
    const WavePressure pressure = forces_.at(height, factors);
    const StillWater& still = forces_.still();
    const double resistance = section.friction * (section.submerged_weight + still.weight) - std::max(still.push, 0.);
    if (pressure.force + section.friction * uplift_gain() * pressure.uplift <= resistance)
      return 0.;  // most waves end here
    if (resistance <= 0.)
      throw std::invalid_argument("the caisson floats, or still water pushes it away: no resistance is left to a wave");
    const SlidingLoad load =
        sliding_load(section, forces_.breakwater().water, pressure, height, forces_.period(), forces_.breakwater().k);
    if (law_ == Law::paper) return sliding_distance_paper(load.mass, load.resistance, load.pulse);
    if (law_ == Law::exact) return sliding_distance_exact(load.mass, load.resistance, load.pulse);
    return combined(section, pressure, load, height, factors);
  }

 private:
  /// Largest value of the uplift over time, relative to U_max.
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

SeaBefore sea_before(const Section& section, const Water& water, const SeaState& state) {
  return sea_before(state.significant_height,
                    {0., state.period, section.water_depth + state.water_level, section.bed_slope}, water.gravity);
}

RayleighHeights::RayleighHeights(double significant_height, double cut, double limit)
    : significant_height_(significant_height),
      highest_(std::min(cut * significant_height, limit)),
      beyond_(std::exp(-2. * cut * cut)),
      at_limit_(0.) {
  if (!(significant_height > 0. && std::isfinite(significant_height) && cut > 0. && limit > 0.))
    throw std::invalid_argument("heights of waves need a significant height, a cut and a limit above 0");
  const double x = limit / significant_height;
  if (limit < cut * significant_height) at_limit_ = std::exp(-2. * x * x) - beyond_;
}

double RayleighHeights::exceedance(double height) const {
  if (height >= highest_) return 0.;
  const double x = std::max(height, 0.) / significant_height_;
  return std::exp(-2. * x * x) - beyond_;
}

double RayleighHeights::density(double height) const {
  if (height <= 0. || height >= highest_) return 0.;
  const double x = height / significant_height_;
  return 4. * x / significant_height_ * std::exp(-2. * x * x);
}

double RayleighHeights::height(double exceedance) const {
  return std::min(significant_height_ * std::sqrt(0.5 * std::max(0., -std::log(exceedance + beyond_))), highest_);
}

double detail::first_height(const std::function<double(double)>& f) {
  constexpr double beyond_all = 1024.;
  double low = 1e-3, high = 8.;  // m
  if (f(low) >= 0.) return 0.;
  for (double value = f(high); value < 0.; value = f(high)) {
    low = high;
    high *= 2.;
    if (high > beyond_all) return std::numeric_limits<double>::infinity();
  }
  boost::uintmax_t most = 100;
  return boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(50), most).first;
}

Section with_factors(const Section& section, const WaveFactors& factors) {
  Section s = section;
  s.friction *= factors.friction;
  const double more = (factors.weight - 1.) * s.weight;
  // more weight acts where W does; W' has the line t, as buoyancy W - W' acts at B/2: W t_W = W' t + (W - W') B/2
  if (s.centroid && s.submerged_weight + more != 0.) {
    const double moment = s.submerged_weight * *s.centroid + (s.weight - s.submerged_weight) * 0.5 * s.width;  // W t_W
    s.centroid = (s.submerged_weight * *s.centroid + (factors.weight - 1.) * moment) / (s.submerged_weight + more);
  }
  s.submerged_weight += more;
  s.weight *= factors.weight;
  return s;
}

namespace {

Breakwater at_level(const Breakwater& breakwater, double rise) {
  Breakwater raised = breakwater;
  raised.section = at_water_level(breakwater.section, breakwater.water, rise);
  return raised;
}

}  // namespace

WaveForces::WaveForces(const Breakwater& breakwater, const SeaState& state)
    : breakwater_(at_level(breakwater, state.water_level)),
      still_(still_water(breakwater_.section, breakwater_.water)),
      period_(state.period),
      goda_(breakwater_.section, breakwater_.water, {0., state.significant_height, state.period, state.angle}) {}

WavePressure WaveForces::at(double height, const WaveFactors& factors, PressureFormula formula) const {
  WavePressure pressure = goda_.at(height, formula);
  pressure.force *= factors.force;
  pressure.force_moment *= factors.force;
  pressure.uplift *= factors.uplift;
  pressure.uplift_moment *= factors.uplift;
  return pressure;
}

double WaveForces::excess(double height, const WaveFactors& factors) const {
  const Section s = with_factors(breakwater_.section, factors);
  const WavePressure p = at(height, factors);
  return p.force + std::max(still_.push, 0.) + s.friction * (p.uplift - s.submerged_weight - still_.weight);
}

/// At rest with still water's push as it is; in the wave as in stability(): it counts where it acts with it.
WorstBase WaveForces::base(double height, const WaveFactors& factors) const {
  const Section s = with_factors(breakwater_.section, factors);
  const WavePressure p = at(height, factors);
  const double B = s.width, own = s.submerged_weight, W = own + still_.weight;
  // dW' is a triangle, B/3 from the heel
  const double of_weight = own * (0.5 * B - s.centroid.value_or(0.5 * B)) + still_.weight * B / 6.;
  const double W_e0 = of_weight + still_.push_moment, with_wave = std::max(still_.push_moment, 0.);
  const double N = W - p.uplift, M_P = p.force_moment + with_wave;
  const double M = of_weight + p.uplift_moment - 0.5 * p.uplift * B + M_P;
  const EdgePressures rest = edge_pressures(W, W_e0, B), wave = edge_pressures(N, M, B);
  WorstBase worst;
  worst.heel_pressure = std::max(above_all(rest.landward), above_all(wave.landward));
  worst.toe_pressure = std::max(above_all(rest.seaward), above_all(wave.seaward));
  const double e = N > 0. ? M / N : 0.;
  worst.eccentricity = std::abs(e) > std::abs(W_e0 / W) ? e : W_e0 / W;
  if (M_P > 0.) worst.overturning_margin = (W * (0.5 * B) - of_weight - p.uplift_moment) / M_P;
  return worst;
}

double WaveForces::threshold(const WaveFactors& factors) const {
  return detail::first_height([&](double height) { return excess(height, factors); });
}

namespace {

/// The height from which S is positive, between two heights. A law's own threshold may be too low, on the safe side;
/// so S is computed upwards from it, in steps and then by bisection.
double first_sliding_height(const SlidingLaw& law, double from, double to) {
  constexpr int steps = 32, halves = 30;
  double low = from, high = infinity;
  for (int i = 1; i <= steps && high == infinity; ++i) {
    const double height = from + (to - from) * i / steps;
    if (law.distance(height) > 0.)
      high = height;
    else
      low = height;
  }
  if (high == infinity) return infinity;
  for (int i = 0; i < halves; ++i) {
    const double middle = 0.5 * (low + high);
    (law.distance(middle) > 0. ? high : low) = middle;
  }
  return low;
}

/// The height that a share of 1e-18 of the waves above `from` exceeds, or the highest height if that is lower.
double top_height(const RayleighHeights& heights, double from) {
  const double log_share = std::log(1e18);
  const double significant_height = heights.significant_height();
  return std::min(heights.highest(),
                  std::sqrt(from * from + 0.5 * log_share * significant_height * significant_height));
}

}  // namespace

Expectation expected_distance(const SlidingLaw& law, const RayleighHeights& heights, double waves,
                              const QuadratureChoice& choice) {
  Expectation result;
  result.threshold = infinity;
  const double safe = law.threshold();
  if (safe == infinity || safe >= heights.highest()) return result;
  const double top = top_height(heights, safe);
  result.threshold = first_sliding_height(law, safe, top);
  if (result.threshold == infinity) return result;
  const auto integrand = [&](double height) { return law.distance(height) * heights.density(height); };
  boost::math::quadrature::gauss_kronrod<double, 31> rule;
  result.distance =
      waves * rule.integrate(integrand, result.threshold, top, choice.depth, choice.tolerance, &result.error);
  result.error *= waves;
  if (heights.at_limit() > 0.) result.broken = waves * heights.at_limit() * law.distance(heights.highest());
  result.distance += result.broken;
  result.sliding_waves = waves * heights.exceedance(result.threshold);
  return result;
}

}  // namespace upbead
