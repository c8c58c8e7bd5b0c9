#include "inside_steps.h"

#include <algorithm>
#include <cmath>

#include "fem/caisson_readings.h"

namespace upbead {

Samples samples(const CompiledScene& compiled, const Series& series, const char* name) {
  return series.reading.row(compiled.system.reading(name));
}

namespace {

constexpr std::size_t most_looks = 16;

std::size_t looks_of(std::size_t n_steps) {
  return std::clamp<std::size_t>(most_looks * 512 / n_steps, 1, most_looks);
}

/// Looks at some points of every step, and closely at the step where it finds the most.
template <typename Value>
Extremum extreme(const std::vector<double>& time, int sign, const Value& value) {
  const std::size_t n_steps = time.size() - 1, looks = looks_of(n_steps);
  Extremum best{time.front(), 0.};
  std::size_t step = 0;
  for (std::size_t n = 0; n < n_steps; ++n)
    for (std::size_t i = 0; i <= looks; ++i) {
      const double t = time[n] + (time[n + 1] - time[n]) * static_cast<double>(i) / static_cast<double>(looks);
      if (const double y = value(n, t); sign * (y - best.value) > 0.) {
        best = {t, y};
        step = n;
      }
    }
  for (std::size_t n = step > 0 ? step - 1 : 0; n < std::min(step + 2, n_steps); ++n) {
    const TimeFunction inside({}, {[&](double t) { return value(n, t); }});
    const Extremum candidate = extremum(inside, time[n], time[n + 1], sign, most_looks);
    if (sign * (candidate.value - best.value) > 0.) best = candidate;
  }
  return best;
}

}  // namespace

InsideSteps::InsideSteps(const CompiledScene& compiled, const Response& response, const TimeFunction& P)
    : time_(response.ends.time),
      x_(samples(compiled, response.ends, reading::displacement_x)),
      v_(samples(compiled, response.ends, reading::velocity_x)),
      P_(P),
      mass_(compiled.caisson->body.mass),
      quintic_(response.ends.time.size() - 1, response.order >= 4) {
  const Samples water = samples(compiled, response.ends, reading::water_force);
  a_ = (water - samples(compiled, response.ends, reading::shear_force)) / mass_;
  for (std::size_t n = 1; n < time_.size(); ++n)
    a_[static_cast<Eigen::Index>(n)] += P_(time_[n], middle(n - 1)) / mass_;
  all_added_mass_ = added_mass(water);
  for (std::size_t n = 0; n < quintic_.size(); ++n) quintic_[n] = quintic_[n] && is_smooth(n);
}

double InsideSteps::jerk(std::size_t n) const {
  return (acceleration(n, n + 1) - acceleration(n, n)) / (time_[n + 1] - time_[n]);
}

/// What x and v say of x_G'' inside the step beside a straight line: no more than what its slope changes by from step
/// to step. More is their round-off, divided by h^2.
bool InsideSteps::is_smooth(std::size_t n) const {
  const double h = time_[n + 1] - time_[n], own = jerk(n);
  double change = n > 0 ? std::abs(own - jerk(n - 1)) : std::abs(own);
  if (n + 2 < time_.size()) change = std::max(change, std::abs(own - jerk(n + 1)));
  const QuinticHermite x = motion(n);
  double bend = 0.;
  for (const double part : {0.25, 0.5, 0.75})
    bend = std::max(bend, std::abs(x(time_[n] + part * h).second - acceleration(n, n) - part * h * own));
  return bend <= 2. * h * change;
}

/// Least squares of water = -m_a x_G''.
double InsideSteps::added_mass(const Samples& water) const {
  const double square = a_.squaredNorm();
  return square > 0. ? std::max(0., -water.dot(a_) / square) : 0.;
}

/// x_G'' at one end of step n, as of that step's own piece of P.
double InsideSteps::acceleration(std::size_t n, std::size_t end) const {
  const double a = a_[static_cast<Eigen::Index>(end)];
  if (end != n) return a;
  const double before = n == 0 ? 0. : P_(time_[n], middle(n - 1));
  return a + (P_(time_[n], middle(n)) - before) / (mass_ + all_added_mass_);
}

QuinticHermite InsideSteps::motion(std::size_t n) const {
  const auto jet = [&](std::size_t end) {
    const auto k = static_cast<Eigen::Index>(end);
    return Jet{x_[k], v_[k], acceleration(n, end)};
  };
  return QuinticHermite(time_[n], time_[n + 1] - time_[n], jet(n), jet(n + 1));
}

double InsideSteps::acceleration_at(std::size_t n, double t) const {
  if (quintic_[n]) return motion(n)(t).second;
  const double weight = (t - time_[n]) / (time_[n + 1] - time_[n]);
  return (1. - weight) * acceleration(n, n) + weight * acceleration(n, n + 1);
}

InsideSteps::WaterPart InsideSteps::split(const Samples& water) const {
  const double m_a = added_mass(water);
  return {m_a, water + m_a * a_};
}

double InsideSteps::shear_force_at(std::size_t n, double t, const WaterPart& water) const {
  const auto k = static_cast<Eigen::Index>(n);
  const double weight = (t - time_[n]) / (time_[n + 1] - time_[n]);
  return P_(t, middle(n)) + (1. - weight) * water.rest[k] + weight * water.rest[k + 1] -
         (mass_ + water.added_mass) * acceleration_at(n, t);
}

Extremum InsideSteps::shear_force(int sign, const Samples& water) const {
  const WaterPart part = split(water);
  return extreme(time_, sign, [&](std::size_t n, double t) { return shear_force_at(n, t, part); });
}

void InsideSteps::for_each(const Samples& water, const std::function<void(double, double, double)>& see) const {
  const WaterPart part = split(water);
  const std::size_t n_steps = time_.size() - 1, looks = looks_of(n_steps);
  for (std::size_t n = 0; n < n_steps; ++n)
    for (std::size_t i = 0; i <= looks; ++i) {
      const double weight = static_cast<double>(i) / static_cast<double>(looks);
      const double t = (1. - weight) * time_[n] + weight * time_[n + 1];
      see(t, shear_force_at(n, t, part), P_(t, middle(n)));
    }
}

Extremum InsideSteps::displacement(int sign) const {
  return extreme(time_, sign, [this](std::size_t n, double t) { return motion(n)(t).value; });
}

}  // namespace upbead
