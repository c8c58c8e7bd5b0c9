#include "upbead/sliding/base_pressure.h"

#include <algorithm>
#include <cmath>

namespace upbead {

EdgePressures edge_pressures(double force, double moment, double width) {
  if (!(force > 0.)) return {};
  const double e = moment / force, least = 1e-3 * width;
  if (std::abs(e) <= width / 6.) return {force / width * (1. - 6. * e / width), force / width * (1. + 6. * e / width)};
  const double edge = 2. * force / (3. * std::max(0.5 * width - std::abs(e), least));
  return e > 0. ? EdgePressures{0., edge} : EdgePressures{edge, 0.};
}

namespace {

/// Margin against overturning about the landward (side 1) or seaward (-1) edge: moment of W' minus U over the moment
/// of the wave; none where the wave does not turn the caisson that way. Without motion it is Goda's (W' t - M_U)/M_P.
std::optional<double> overturning_margin(const EffectiveBase& base, std::size_t i, double side) {
  const double arm = 0.5 * base.width;
  const double holds = (base.weight - base.uplift[i]) * arm - side * (base.weight_moment + base.uplift_moment[i]);
  const double all = base.force[i] * arm - side * base.moment[i], overturns = holds - all;
  if (!(overturns > 1e-9 * base.weight * arm)) return std::nullopt;
  return holds / overturns;
}

void look_at_edges(const EffectiveBase& base, std::size_t i, double time, BaseExtremes& s) {
  const EdgePressures edges = edge_pressures(base.force[i], base.moment[i], base.width);
  const double e = base.force[i] > 0. ? base.moment[i] / base.force[i] : 0.;
  const auto see = [&](double pressure, bool leaves, std::optional<double>& peak, double& when) {
    if (!peak || !(pressure > *peak || leaves)) return;
    peak = leaves ? std::nullopt : std::optional(pressure);
    when = time;
  };
  const bool leaves = std::abs(base.moment[i]) >= 0.5 * base.width * base.force[i];
  see(edges.landward, leaves && base.moment[i] >= 0., s.peak_heel_pressure, s.peak_heel_pressure_time);
  see(edges.seaward, leaves && base.moment[i] <= 0., s.peak_toe_pressure, s.peak_toe_pressure_time);
  if (std::abs(e) > std::abs(s.largest_eccentricity)) {
    s.largest_eccentricity = e;
    s.largest_eccentricity_time = time;
  }
  if (base.force[i] < s.least_normal_force) {
    s.least_normal_force = base.force[i];
    s.least_normal_force_time = time;
  }
  for (const double side : {1., -1.})
    if (const auto margin = overturning_margin(base, i, side);
        margin && (!s.least_overturning_margin || *margin < *s.least_overturning_margin)) {
      s.least_overturning_margin = margin;
      s.least_overturning_margin_time = time;
    }
}

}  // namespace

BaseExtremes base_extremes(const EffectiveBase& base, const std::vector<double>& time) {
  BaseExtremes s;
  const EdgePressures rest = edge_pressures(base.weight, base.weight_moment, base.width);
  s.heel_pressure_at_rest = rest.landward;
  s.toe_pressure_at_rest = rest.seaward;
  s.eccentricity_at_rest = base.weight_moment / base.weight;
  s.least_normal_force = base.weight;
  for (std::size_t i = 0; i < base.force.size(); ++i) look_at_edges(base, i, time[i], s);
  return s;
}

WorstBase worst_of(const BaseExtremes& s) {
  const double e = std::abs(s.eccentricity_at_rest) > std::abs(s.largest_eccentricity) ? s.eccentricity_at_rest
                                                                                       : s.largest_eccentricity;
  return {std::max(s.heel_pressure_at_rest, s.peak_heel_pressure.value_or(WorstBase::leaves)),
          std::max(s.toe_pressure_at_rest, s.peak_toe_pressure.value_or(WorstBase::leaves)), e,
          s.least_overturning_margin.value_or(WorstBase::leaves)};
}

WorstBase worst_of(const WorstBase& a, const WorstBase& b) {
  return {std::max(a.heel_pressure, b.heel_pressure), std::max(a.toe_pressure, b.toe_pressure),
          std::abs(b.eccentricity) > std::abs(a.eccentricity) ? b.eccentricity : a.eccentricity,
          std::min(a.overturning_margin, b.overturning_margin)};
}

}  // namespace upbead
