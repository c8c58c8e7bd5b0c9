#include "upbead/response/shear_response.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "upbead/base/error.h"
#include "upbead/dynamics/interpolate.h"
#include "upbead/fem/caisson_readings.h"

namespace upbead {

namespace {

using Samples = Eigen::RowVectorXd;

Samples samples(const CompiledScene& compiled, const Series& series, const char* name) {
  return series.reading.row(compiled.system.reading(name));
}

/// F_T and x_G between the ends of each step. A scheme of order 4 has x_G, x_G' and x_G'' good enough for a quintic; of
/// order 2 their errors, divided by h^2, would spoil its second derivative, so x_G'' is linear there.
class InsideSteps {
 public:
  InsideSteps(const CompiledScene& compiled, const Response& response, const TimeFunction& P, int order)
      : time_(response.ends.time),
        x_(samples(compiled, response.ends, reading::displacement_x)),
        v_(samples(compiled, response.ends, reading::velocity_x)),
        F_(samples(compiled, response.ends, reading::shear_force)),
        P_(P),
        mass_(compiled.caisson->body.mass),
        quintic_(order >= 4) {}

  Extremum shear_force(int sign) const {
    return extreme(sign, [this](std::size_t n, double t) {
      return P_(t, middle(n)) - mass_ * (quintic_ ? motion(n)(t).second : linear_acceleration(n, t));
    });
  }

  Extremum displacement(int sign) const {
    return extreme(sign, [this](std::size_t n, double t) { return motion(n)(t).value; });
  }

 private:
  double middle(std::size_t n) const { return 0.5 * (time_[n] + time_[n + 1]); }

  /// x_G, x_G' and x_G'' = (P - F_T)/m at one end of step n, with the step's own piece of P.
  Jet jet(std::size_t n, std::size_t end) const {
    const auto k = static_cast<Eigen::Index>(end);
    return {x_[k], v_[k], (P_(time_[end], middle(n)) - F_[k]) / mass_};
  }

  QuinticHermite motion(std::size_t n) const {
    return QuinticHermite(time_[n], time_[n + 1] - time_[n], jet(n, n), jet(n, n + 1));
  }

  double linear_acceleration(std::size_t n, double t) const {
    const double weight = (t - time_[n]) / (time_[n + 1] - time_[n]);
    return (1. - weight) * jet(n, n).second + weight * jet(n, n + 1).second;
  }

  template <typename Value>
  Extremum extreme(int sign, const Value& value) const {
    Extremum best{time_.front(), 0.};
    for (std::size_t n = 0; n + 1 < time_.size(); ++n) {
      const TimeFunction inside({}, {[&](double t) { return value(n, t); }});
      const Extremum candidate = extremum(inside, time_[n], time_[n + 1], sign, 16);
      if (sign * (candidate.value - best.value) > 0.) best = candidate;
    }
    return best;
  }

  const std::vector<double>& time_;
  Samples x_, v_, F_;
  const TimeFunction& P_;
  double mass_;
  bool quintic_;
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

double largest(const Samples& values) {
  return values.cwiseAbs().maxCoeff();
}

double reaction_mismatch(const CompiledScene& compiled, const Series& balanced) {
  const Samples by_ground = samples(compiled, balanced, reading::shear_force);
  const Samples by_inertia = samples(compiled, balanced, reading::shear_by_inertia);
  const double other_forces = std::max(largest(samples(compiled, balanced, reading::force)),
                                       largest(samples(compiled, balanced, reading::normal_force)));
  const double scale = std::max(largest(by_ground), 1e-6 * other_forces);
  return scale > 0. ? largest(by_ground - by_inertia) / scale : 0.;
}

/// Ratios of the peaks in the direction of the largest |P|.
void set_ratios(ShearResponse& r, double duration) {
  const bool seaward = -r.peak_force_seaward > r.peak_force;
  const double force = seaward ? r.peak_force_seaward : r.peak_force;
  const double shear = seaward ? r.peak_shear_seaward : r.peak_shear;
  if (force != 0.) r.shear_to_force_ratio = shear / force;
  if (std::abs(r.impulse) > 1e-9 * std::abs(force) * duration) r.shear_to_impulse = shear / r.impulse;
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
  const InsideSteps inside(compiled, response, P, response.order);
  const Samples F_T = samples(compiled, response.ends, reading::shear_force);
  const Extremum force = extremum(P, 0., time.back(), 1), force_seaward = extremum(P, 0., time.back(), -1);
  const Extremum landward = inertia ? inside.shear_force(1) : at_ends(time, F_T, 1);
  const Extremum seaward = inertia ? inside.shear_force(-1) : at_ends(time, F_T, -1);

  ShearResponse r;
  r.peak_force = force.value;
  r.peak_force_time = force.time;
  r.peak_force_seaward = force_seaward.value;
  r.peak_force_seaward_time = force_seaward.time;
  r.impulse = integral(P, 0., time.back());
  r.peak_shear = landward.value;
  r.peak_shear_time = landward.time;
  r.peak_shear_seaward = seaward.value;
  r.peak_shear_seaward_time = seaward.time;
  r.peak_shear_paper = r.peak_shear;  // no water is modelled around the caisson, so both readings are one
  set_ratios(r, time.back());
  r.peak_displacement =
      inertia ? inside.displacement(1).value : samples(compiled, response.ends, reading::displacement_x).maxCoeff();
  r.peak_rotation = samples(compiled, response.ends, reading::rotation).maxCoeff();
  const bool seaward_force = -r.peak_force_seaward > r.peak_force;
  r.arm = arm_at(compiled, seaward_force ? r.peak_force_seaward_time : r.peak_force_time);
  r.peak_base_moment = samples(compiled, response.ends, reading::base_moment).maxCoeff();
  r.reaction_mismatch = reaction_mismatch(compiled, response.balanced);
  return r;
}

void require_balance(const ShearResponse& shear, const EnergyAccount& energy) {
  constexpr double tolerable = 1e-6;
  const auto require = [](double mismatch, const std::string& what) {
    if (mismatch <= tolerable) return;
    std::ostringstream text;
    text << what << " by " << mismatch << "; nothing was written, as such an answer is not to be trusted";
    throw NumericsError(text.str());
  };
  require(shear.reaction_mismatch, "both routes to the shear force differ");
  require(energy.mismatch(), "the work of the loads and what became of it differ");
}

}  // namespace upbead
