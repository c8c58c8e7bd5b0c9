#include "upbead/expected/wave_forces.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <limits>

#include "first_height.h"

namespace upbead {

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
  s.buoyant_weight += (factors.weight - 1.) * s.weight;
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
      period_(state.period),
      goda_(breakwater_.section, breakwater_.water, {0., state.significant_height, state.period, state.angle}) {}

WavePressure WaveForces::at(double height, const WaveFactors& factors, PressureFormula formula) const {
  WavePressure pressure = goda_.at(height, formula);
  pressure.force *= factors.force;
  pressure.uplift *= factors.uplift;
  return pressure;
}

double WaveForces::excess(double height, const WaveFactors& factors) const {
  const Section s = with_factors(breakwater_.section, factors);
  const WavePressure p = at(height, factors);
  return p.force + s.friction * (p.uplift - s.buoyant_weight);
}

double WaveForces::threshold(const WaveFactors& factors) const {
  return detail::first_height([&](double height) { return excess(height, factors); });
}

}  // namespace upbead
