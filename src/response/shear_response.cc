#include "upbead/response/shear_response.h"

#include <algorithm>
#include <cmath>

#include "upbead/dynamics/interpolate.h"
#include "upbead/fem/caisson_readings.h"

namespace upbead {

namespace {

using Samples = Eigen::RowVectorXd;

Samples samples(const CompiledScene& compiled, const Series& series, const char* name) {
  return series.reading.row(compiled.system.reading(name));
}

/// F_T and x_G between the ends of each step.
class InsideSteps {
 public:
  InsideSteps(const CompiledScene& compiled, const Response& response, const TimeFunction& P)
      : time_(response.ends.time),
        x_(samples(compiled, response.ends, reading::displacement_x)),
        v_(samples(compiled, response.ends, reading::velocity_x)),
        F_(samples(compiled, response.ends, reading::shear_force)),
        P_(P),
        mass_(compiled.caisson->body.mass) {}

  std::size_t n_steps() const { return time_.size() - 1; }

  /// The step's F_T(t) and x_G(t) as a pair of functions would be; here: value(t, true) is F_T, else x_G.
  TimeFunction step(std::size_t n, bool shear) const {
    const double begin = time_[n], end = time_[n + 1], middle = 0.5 * (begin + end);
    const auto jet = [&](std::size_t i) {
      const auto k = static_cast<Eigen::Index>(i);
      return Jet{x_[k], v_[k], (P_(time_[i], middle) - F_[k]) / mass_};
    };
    const QuinticHermite x(begin, end - begin, jet(n), jet(n + 1));
    if (!shear) return TimeFunction({}, {[x](double t) { return x(t).value; }});
    return TimeFunction({}, {[x, middle, P = P_, m = mass_](double t) { return P(t, middle) - m * x(t).second; }});
  }

  Extremum extreme(bool shear, int sign) const {
    Extremum best{time_.front(), 0.};
    for (std::size_t n = 0; n < n_steps(); ++n) {
      const Extremum candidate = extremum(step(n, shear), time_[n], time_[n + 1], sign, 16);
      if (sign * (candidate.value - best.value) > 0.) best = candidate;
    }
    return best;
  }

 private:
  const std::vector<double>& time_;
  Samples x_, v_, F_;
  const TimeFunction& P_;
  double mass_;
};

Extremum at_ends(const std::vector<double>& time, const Samples& values, int sign) {
  Eigen::Index at = 0;
  (sign * values).maxCoeff(&at);
  return {time[static_cast<std::size_t>(at)], values[at]};
}

/// Height of the resultant of all loads above the bottom at one time (m).
std::optional<double> arm_at(const CompiledScene& compiled, double time) {
  LoadOnCaisson total;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
    const double f = compiled.system.loads[k].history(time);
    total.force_x += compiled.loads_on_caisson[k].force_x * f;
    total.moment += compiled.loads_on_caisson[k].moment * f;
  }
  return total.arm();
}

double reaction_mismatch(const CompiledScene& compiled, const Series& balanced) {
  const Samples by_ground = samples(compiled, balanced, reading::shear_force);
  const Samples by_inertia = samples(compiled, balanced, reading::shear_by_inertia);
  const double largest = by_ground.cwiseAbs().maxCoeff();
  return largest > 0. ? (by_ground - by_inertia).cwiseAbs().maxCoeff() / largest : 0.;
}

}  // namespace

TimeFunction force_on_caisson(const CompiledScene& compiled) {
  TimeFunction P;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k)
    if (const double weight = compiled.loads_on_caisson[k].force_x; weight != 0.)
      P = sum(P, scaled(compiled.system.loads[k].history, weight));
  return P;
}

ShearResponse read_shear_response(const CompiledScene& compiled, const Response& response, bool inertia) {
  const std::vector<double>& time = response.ends.time;
  const TimeFunction P = force_on_caisson(compiled);
  const InsideSteps inside(compiled, response, P);
  const Samples F_T = samples(compiled, response.ends, reading::shear_force);
  const Extremum force = extremum(P, 0., time.back(), 1);
  const Extremum landward = inertia ? inside.extreme(true, 1) : at_ends(time, F_T, 1);
  const Extremum seaward = inertia ? inside.extreme(true, -1) : at_ends(time, F_T, -1);

  ShearResponse r;
  r.peak_force = force.value;
  r.peak_force_time = force.time;
  r.impulse = integral(P, 0., time.back());
  r.peak_shear = landward.value;
  r.peak_shear_time = landward.time;
  r.peak_shear_seaward = seaward.value;
  r.peak_shear_seaward_time = seaward.time;
  r.peak_shear_paper = r.peak_shear;  // no water is modelled around the caisson, so both readings are one
  if (r.peak_force != 0.) r.shear_to_force_ratio = r.peak_shear / r.peak_force;
  if (r.impulse != 0.) r.shear_to_impulse = r.peak_shear / r.impulse;
  r.peak_displacement =
      inertia ? inside.extreme(false, 1).value : samples(compiled, response.ends, reading::displacement_x).maxCoeff();
  r.peak_rotation = samples(compiled, response.ends, reading::rotation).maxCoeff();
  r.arm = arm_at(compiled, r.peak_force_time);
  r.peak_base_moment = samples(compiled, response.ends, reading::base_moment).maxCoeff();
  r.reaction_mismatch = reaction_mismatch(compiled, response.balanced);
  return r;
}

}  // namespace upbead
