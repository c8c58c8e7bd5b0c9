#include "upbead/sliding/base_pressure.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace upbead {

namespace {

/// Margin against overturning about the landward (side 1) or seaward (-1) edge: moment of W' and of vertical loads
/// minus U, over the moment of the wave and of still water's push; none where these do not turn the caisson that way.
/// Without motion it is Goda's (W' t - M_U)/M_P.
std::optional<double> overturning_margin(const EffectiveBase& base, std::size_t i, double side) {
  const double arm = 0.5 * base.width;
  const double of_weight = base.weight_moment - base.push_moment;
  double holds = (base.weight - base.uplift[i]) * arm - side * (of_weight + base.uplift_moment[i]);
  if (!base.vertical.empty()) holds += base.vertical[i] * arm - side * base.vertical_moment[i];
  if (holds <= 0.) return 0.;  // it is lifted, whatever turns it
  const double all = base.force[i] * arm - side * base.moment[i], overturns = holds - all;
  if (!(overturns > 1e-9 * base.weight * arm)) return std::nullopt;
  return holds / overturns;
}

void look_at_edges(const EffectiveBase& base, std::size_t i, double time, BaseExtremes& s) {
  const EdgePressures edges = edge_pressures(base.force[i], base.moment[i], base.width);
  const double e = base.force[i] > 0. ? base.moment[i] / base.force[i] : 0.;
  const auto see = [time](const std::optional<double>& pressure, std::optional<double>& peak, double& when) {
    if (!(above_all(pressure) > above_all(peak))) return;
    peak = pressure;
    when = time;
  };
  see(edges.landward, s.peak_heel_pressure, s.peak_heel_pressure_time);
  see(edges.seaward, s.peak_toe_pressure, s.peak_toe_pressure_time);
  const double least = std::min(above_all(edges.seaward), above_all(edges.landward));
  if (!s.lifts_time && (least <= 0. || base.force[i] <= 0.)) {
    s.lifts_time = time;
    s.lifts = base.force[i] <= 0. ? "all" : base.moment[i] > 0. ? "seaward" : "landward";
  }
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
  s.heel_pressure_at_rest = rest.landward.value_or(0.);
  s.toe_pressure_at_rest = rest.seaward.value_or(0.);
  s.eccentricity_at_rest = base.weight_moment / base.weight;
  s.least_normal_force = base.weight;
  for (std::size_t i = 0; i < base.force.size(); ++i) look_at_edges(base, i, time[i], s);
  return s;
}

EdgeStress least_edge_stress(const EffectiveBase& base, const std::vector<double>& time) {
  // It has more stress at its edges than a linear distribution: it opens at 1.26 times the moment at which the linear
  // stress of an edge becomes tension, docs/slip.md.
  constexpr double edge_factor = 1.26;
  EdgeStress least{1e300};
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double B = base.width, force = base.force[i], moment = base.moment[i];
    const double stress = force / B - 6. * std::abs(moment) / (edge_factor * B * B);
    if (stress < least.stress) least = {stress, force, moment, time[i]};
  }
  return least;
}

std::string lifts_text(const EdgeStress& least) {
  const std::string which = least.force < 0.    ? "the whole base"
                            : least.moment > 0. ? "the seaward edge"
                                                : "the landward edge";
  return which + " lifts at " + significant(least.time) + " s: bonded, as here, it bears a tension of " +
         with_unit(-least.stress, "Pa") + ", which a real base does not (N' = " + with_unit(least.force, "N/m") +
         ", moment " + with_unit(least.moment, "N m/m") + ")";
}

WorstBase worst_of(const BaseExtremes& s) {
  const double e = std::abs(s.eccentricity_at_rest) > std::abs(s.largest_eccentricity) ? s.eccentricity_at_rest
                                                                                       : s.largest_eccentricity;
  return {std::max(s.heel_pressure_at_rest, above_all(s.peak_heel_pressure)),
          std::max(s.toe_pressure_at_rest, above_all(s.peak_toe_pressure)), e, above_all(s.least_overturning_margin)};
}

WorstBase worst_of(const WorstBase& a, const WorstBase& b) {
  return {std::max(a.heel_pressure, b.heel_pressure), std::max(a.toe_pressure, b.toe_pressure),
          std::abs(b.eccentricity) > std::abs(a.eccentricity) ? b.eccentricity : a.eccentricity,
          std::min(a.overturning_margin, b.overturning_margin), std::min(a.edge_stress, b.edge_stress)};
}

}  // namespace upbead
