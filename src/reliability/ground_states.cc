// Limit states by F_T and the forces on the base in the wave's P(t), of a reduced model.
#include <algorithm>
#include <cmath>

#include "reliability/section_model.h"

namespace upbead {

namespace {

/// 1 - 1/m of the least overturning margin m, 1 where nothing overturns: 0 where the resultant reaches an edge. An
/// uplift that overturns by itself has m < 0, and counts as far beyond.
double held_up(const WorstBase& base) {
  constexpr double least = 1e-3;
  return 1. - 1. / std::max(base.overturning_margin, least);
}

/// limit/p_e - 1, which goes on where the resultant has left the base and there is no p_e.
double below_pressure(const WorstBase& base, double limit) {
  if (std::isfinite(base.heel_pressure)) return limit / base.heel_pressure - 1.;
  return -1. + std::min(held_up(base), 0.);
}

}  // namespace

std::vector<SectionLimitState> ground_states(const SectionPoint& at, bool knows_base) {
  const double scale = at.section.friction * at.section.submerged_weight;
  using Of = std::function<double(const SectionPoint&)>;
  const auto state = [](const char* name, const char* meaning, const Of& margin, const std::string& why_not = "") {
    const Of answered = [margin](const SectionPoint& p) { return p.ground().why_not.empty() ? margin(p) : -1.; };
    return SectionLimitState{name, meaning, why_not.empty() ? answered : Of(), why_not, false, true};
  };
  const std::string no_base = knows_base ? "" : "the model of [dynamics] has no readings of the base";
  const std::string no_pressure =
      at.limits.base_pressure ? no_base : "no limits.base_pressure: give the pressure (Pa) that the mound bears";
  return {state("sliding_dynamic", "the caisson slides, mu (W' - U) < F_T at any time",
                [scale](const SectionPoint& p) { return (p.ground().resistance - p.ground().force) / scale; }),
          state(
              "sliding_distance_dynamic", "S of one wave by F_T(t) above limits.sliding",
              [scale](const SectionPoint& p) { return (p.ground().resistance - *p.ground().holding) / scale; },
              at.limits.sliding ? "" : "no limits.sliding: give the S (m) that is too far"),
          state(
              "overturning_dynamic", "the resultant on the base leaves it at any time",
              [](const SectionPoint& p) { return held_up(*p.ground().base); }, no_base),
          state(
              "heel_pressure_dynamic", "heel pressure p_e at any time above limits.base_pressure",
              [](const SectionPoint& p) { return below_pressure(*p.ground().base, *p.limits.base_pressure); },
              no_pressure)};
}

}  // namespace upbead
