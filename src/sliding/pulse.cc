#include "upbead/sliding/pulse.h"

#include <cmath>
#include <stdexcept>

namespace upbead {

namespace {

/// C = mu W' tau_0^2 / mass (m), the scale of all distances, and r = F_Smax / (mu W').
struct Scale {
  double C = 0., r = 0.;
};

Scale scale(double mass, double resistance, const TriangularPulse& pulse) {
  if (!(mass > 0. && resistance > 0. && pulse.duration >= 0.))
    throw std::invalid_argument("a sliding distance needs mass > 0, resistance > 0 and duration >= 0");
  return {resistance * pulse.duration * pulse.duration / mass, pulse.peak / resistance};
}

}  // namespace

History history(const TriangularPulse& pulse) {
  return {{0., 0.5 * pulse.duration, pulse.duration}, {0., pulse.peak, 0.}};
}

double sliding_distance_paper(double mass, double resistance, const TriangularPulse& pulse) {
  const auto [C, r] = scale(mass, resistance, pulse);
  return r > 1. ? C * std::pow(r - 1., 3) * (r + 1.) / (8. * r * r) : 0.;
}

PaperParts sliding_distance_paper_parts(double mass, double resistance, const TriangularPulse& pulse) {
  const auto [C, r] = scale(mass, resistance, pulse);
  if (r <= 1.) return {};
  return {C * std::pow(r - 1., 3) / (4. * r * r), C * std::pow(r - 1., 4) / (8. * r * r)};
}

double sliding_distance_exact(double mass, double resistance, const TriangularPulse& pulse) {
  const auto [C, r] = scale(mass, resistance, pulse);
  if (r <= 1.) return 0.;
  if (r <= 1. + std::sqrt(0.5)) return C * (0.25 + std::sqrt(2.) / 6.) * std::pow(r - 1., 3) / (r * r);
  return C / 8. * (std::pow(r - 1., 2) - 1. / (12. * r * r));
}

SlidingLoad sliding_load(const Section& section, const Water& water, const WavePressure& pressure, double height,
                         double period, const DurationFactor& k) {
  const Stability s = stability(section, pressure, still_water(section, water));
  const double tau_0 = k(pressure.alpha_star) * standing_duration(height, section.water_depth, period);
  return {s.resistance, section.weight / water.gravity, {s.sliding_force, tau_0}};
}

}  // namespace upbead
