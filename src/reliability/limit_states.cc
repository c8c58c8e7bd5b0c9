#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "reliability/answer.h"
#include "reliability/section_model.h"
#include "upbead/sliding/pulse.h"

namespace upbead {

namespace {

/// What still water at two levels does counts as in stability(): dW' always, a push where it acts with the wave.
double vertical(const SectionPoint& at) {
  return at.section.submerged_weight + at.still.weight - at.pressure.uplift;
}

/// mu (W' + dW' - U) - P - push over mu W' of the certain section: S.F. = 1 is its zero [Goda 2000].
double against_sliding(const SectionPoint& at, double scale) {
  return (at.section.friction * vertical(at) - at.pressure.force - std::max(at.still.push, 0.)) / scale;
}

double arm(const Section& s) {
  return s.centroid.value_or(0.5 * s.width);
}

/// W' t + dW' B/3 - M_U - M_P - M_push (N m/m) [Goda 2000].
double moment_about_heel(const SectionPoint& at) {
  const Section& s = at.section;
  return s.submerged_weight * arm(s) + at.still.weight * s.width / 3. - at.pressure.uplift_moment -
         at.pressure.force_moment - std::max(at.still.push_moment, 0.);
}

/// limit/p_e - 1, which goes on where there is no p_e: of a triangle, 1/p_e = 3 t_e/(2 W_e) [Goda 2000], falls through
/// 0 as the resultant leaves the base; a caisson that floats is beyond that.
double against_pressure(const SectionPoint& at, double limit) {
  const Section& s = at.section;
  const double force = vertical(at), moment = moment_about_heel(at);
  if (force <= 0.) return -1. + std::min(force / std::abs(s.weight), 0.) - std::max(moment, 0.);
  if (const auto pressure = stability(s, at.pressure, at.still).heel_pressure) return limit / *pressure - 1.;
  return 1.5 * limit * moment / (force * force) - 1.;
}

SectionLimitState without(const std::string& name, const std::string& meaning, const std::string& why_not) {
  return {name, meaning, {}, why_not, false};
}

SectionLimitState distance_state(const std::string& name, double limit) {
  return {name, "S of one wave by eqs. (4) and (6) above " + significant(limit, 3) + " m",
          [limit](const SectionPoint& at) { return sliding_margin(at, limit); }, "", true};
}

/// mu (W' + dW') - P - push over mu W' of the certain section, with the push of a higher harbour; no suction under the
/// base, as in standing_answer().
SectionLimitState seaward_state(const SeawardForce& seaward, double scale) {
  const std::string meaning = "safety factor against sliding seaward below 1 in the trough, mu W' < P";
  if (!seaward.of_height) return without("sliding_seaward", meaning, seaward.why_not);
  return {"sliding_seaward",
          meaning + "; waves above " + significant(seaward.highest, 3) + " m with the force of that height",
          [seaward, scale](const SectionPoint& at) {
            const double holds = at.section.friction * (at.section.submerged_weight + at.still.weight);
            const double push = std::max(-at.still.push, 0.);
            return (holds - at.force_factor * seaward.of_height(at.height) - push) / scale;
          },
          "", false};
}

}  // namespace

/// With r = F_Smax/(mu W') and C = mu W' tau_0^2/m, S = C (1/4 + sqrt(2)/6) (r - 1)^3/r^2 while the block stops within
/// the pulse (sliding_distance_exact). Its cube root d = (r - 1)/r^(2/3) goes on below r = 1, where S = 0, and is
/// smooth there; S > limit where d > (limit/(C (1/4 + sqrt(2)/6)))^(1/3).
double sliding_margin(const SectionPoint& at, double limit) {
  const double shape = 0.25 + std::sqrt(2.) / 6.;
  const auto& [resistance, mass, pulse] = at.load;
  if (resistance <= 0.) return -1. + resistance / (mass * 9.81);  // nothing holds it
  const double r = pulse.peak / resistance, scale = shape * resistance * pulse.duration * pulse.duration / mass;
  const double demand = r > 1. ? std::cbrt(sliding_distance_exact(mass, resistance, pulse) / scale)
                               : (r - 1.) / std::cbrt(std::max(r * r, 1e-4));
  return std::cbrt(limit / (scale * std::max(at.sliding_factor, 1e-12))) - demand;
}

std::vector<SectionLimitState> section_limit_states(const SectionPoint& at, const SeawardForce& seaward) {
  const Section& s = at.section;
  const double friction = s.friction * s.submerged_weight, moment = s.submerged_weight * arm(s);
  std::vector<SectionLimitState> list{
      {"sliding", "safety factor against sliding below 1, mu (W' - U) < P",
       [friction](const SectionPoint& p) { return against_sliding(p, friction); }, "", false},
      {"overturning", "safety factor against overturning below 1, W' t - M_U < M_P",
       [moment](const SectionPoint& p) { return moment_about_heel(p) / moment; }, "", false}};
  const char* const too_far = "S of one wave by eqs. (4) and (6) above limits.sliding";
  const char* const pressed = "heel pressure p_e above limits.base_pressure";
  if (at.limits.sliding)
    list.push_back({"sliding_distance", too_far,
                    [](const SectionPoint& p) { return sliding_margin(p, *p.limits.sliding); }, "", false});
  else
    list.push_back(without("sliding_distance", too_far, "no limits.sliding: give the S (m) that is too far"));
  if (at.limits.base_pressure)
    list.push_back({"heel_pressure", pressed,
                    [](const SectionPoint& p) { return against_pressure(p, *p.limits.base_pressure); }, "", false});
  else
    list.push_back(
        without("heel_pressure", pressed, "no limits.base_pressure: give the pressure (Pa) that the mound bears"));
  list.push_back(seaward_state(seaward, friction));
  list.push_back(distance_state("sliding_0_1", 0.1));
  list.push_back(distance_state("sliding_0_3", 0.3));
  list.push_back(distance_state("sliding_1_0", 1.0));
  return list;
}

std::vector<std::string> limit_state_names() {
  return {"sliding",         "overturning", "sliding_distance", "heel_pressure",
          "sliding_seaward", "sliding_0_1", "sliding_0_3",      "sliding_1_0"};
}

std::vector<std::string> ground_state_names() {
  return {"sliding_dynamic", "sliding_distance_dynamic", "overturning_dynamic", "heel_pressure_dynamic"};
}

}  // namespace upbead
