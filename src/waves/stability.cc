#include "upbead/waves/stability.h"

namespace upbead {

namespace {

/// p_e under the heel [Goda 2000]: a triangle where the resultant lies in the outer third, else a trapezium.
double toe_pressure(double width, double vertical, double moment) {
  if (vertical <= 0.) return 0.;  // lifted off: nothing presses on the mound
  const double t_e = moment / vertical;
  if (t_e <= width / 3.) return 2. * vertical / (3. * t_e);
  return 2. * vertical / width * (2. - 3. * t_e / width);
}

}  // namespace

Stability stability(const Section& section, const WavePressure& pressure) {
  const double t = section.centroid.value_or(0.5 * section.width);
  const double vertical = section.buoyant_weight - pressure.uplift;
  const double resisting = section.buoyant_weight * t - pressure.uplift_moment;
  Stability s;
  s.safety_sliding = section.friction * vertical / pressure.force;
  s.safety_overturning = resisting / pressure.force_moment;
  s.toe_pressure = toe_pressure(section.width, vertical, resisting - pressure.force_moment);
  s.sliding_force = pressure.force + section.friction * pressure.uplift;
  s.resistance = section.friction * section.buoyant_weight;
  s.ratio = s.sliding_force / s.resistance;
  return s;
}

double buoyant_weight_for(double safety_sliding, double friction, const WavePressure& pressure) {
  return safety_sliding * pressure.force / friction + pressure.uplift;
}

}  // namespace upbead
