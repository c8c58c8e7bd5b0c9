#include "upbead/sliding/history_sliding.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sliding/force_pieces.h"
#include "upbead/sliding/pulse.h"

namespace upbead {

namespace {

using Distance = double (*)(double, double, const TriangularPulse&);

/// Duration of the pulse with this S, as S is proportional to tau_0^2.
std::optional<double> of_equal_distance(Distance distance, double mass, double resistance, double peak, double S) {
  const double of_one_second = distance(mass, resistance, {peak, 1.});
  if (!(S > 0. && of_one_second > 0.)) return std::nullopt;
  return std::sqrt(S / of_one_second);
}

/// Part of a linear piece on which it is above `level`, as fractions; empty where from >= to.
struct Part {
  double from = 0., to = 0.;
};

Part part_above(double begin, double end, double level) {
  if (begin <= level && end <= level) return {};
  const double cross = begin == end ? 0. : (level - begin) / (end - begin);
  return {begin > level ? 0. : cross, end > level ? 1. : cross};
}

/// Seconds with F_S > level.
double time_above(const History& force, double level) {
  double sum = 0.;
  for (std::size_t i = 1; i < force.time.size(); ++i) {
    const Part part = part_above(force.value[i - 1], force.value[i], level);
    sum += (part.to - part.from) * (force.time[i] - force.time[i - 1]);
  }
  return sum;
}

/// Integral of F_S over one piece where it is above 0.
double positive_impulse(const History& force, std::size_t i) {
  const double begin = force.value[i - 1], end = force.value[i];
  const Part part = part_above(begin, end, 0.);
  return 0.5 * (std::max(begin, 0.) + std::max(end, 0.)) * (part.to - part.from) * (force.time[i] - force.time[i - 1]);
}

/// Impulse from the last time before the peak at which F_S <= 0 to the first such time after it.
double impulse_of_lobe(const History& force, std::size_t peak) {
  double sum = 0.;
  for (std::size_t i = peak; i > 0 && force.value[i] > 0.; --i) sum += positive_impulse(force, i);
  for (std::size_t i = peak + 1; i < force.time.size() && force.value[i - 1] > 0.; ++i)
    sum += positive_impulse(force, i);
  return sum;
}

/// a + factor b, at the times of both; `b` without points is zero.
History sum(const History& a, double factor, const History& b) {
  History result;
  const auto add = [&result, factor](double t, double x, double y) {
    if (!result.time.empty() && result.time.back() == t && result.value.back() == x + factor * y) return;
    result.time.push_back(t);
    result.value.push_back(x + factor * y);
  };
  for (const LinearPiece& piece : linear_pieces(a, b)) {
    add(piece.start, piece.first.begin, piece.second.begin);
    add(piece.start + piece.length, piece.first.end, piece.second.end);
  }
  return result;
}

History negative(History history) {
  for (double& value : history.value) value = -value;
  return history;
}

/// factor (level + history), not below 0; exact at the zero of the line.
History friction_of(double factor, double level, const History& history) {
  if (history.time.empty()) return {{0.}, {factor * level}};
  History result{{history.time.front()}, {factor * level}};  // before the wave
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    const double value = level + history.value[i];
    if (i > 0) {
      const double before = level + history.value[i - 1];
      if (before * value < 0.) {
        const double part = before / (before - value);
        result.time.push_back(history.time[i - 1] + part * (history.time[i] - history.time[i - 1]));
        result.value.push_back(0.);
      }
    }
    result.time.push_back(history.time[i]);
    result.value.push_back(factor * std::max(value, 0.));
  }
  result.time.push_back(result.time.back());
  result.value.push_back(factor * level);  // after it
  return result;
}

double value_at(const History& history, double t) {
  for (std::size_t i = 1; i < history.time.size(); ++i)
    if (history.time[i - 1] <= t && t <= history.time[i] && history.time[i - 1] < history.time[i]) {
      const double part = (t - history.time[i - 1]) / (history.time[i] - history.time[i - 1]);
      return (1. - part) * history.value[i - 1] + part * history.value[i];
    }
  return 0.;
}

double least(const History& history) {
  return history.value.empty() ? 0. : std::min(0., *std::min_element(history.value.begin(), history.value.end()));
}

}  // namespace

std::size_t peak_index(const History& force) {
  return static_cast<std::size_t>(std::max_element(force.value.begin(), force.value.end()) - force.value.begin());
}

HistoryDuration history_duration(double mass, const History& force, double ratio) {
  const std::size_t peak = peak_index(force);
  if (!(ratio > 0. && peak < force.value.size() && force.value[peak] > 0.))
    throw std::invalid_argument("tau_0 of a history needs r > 0 and a force above 0");
  const double F = force.value[peak], resistance = F / ratio;
  HistoryDuration result;
  result.ratio = ratio;
  result.sliding = slide(mass, force, resistance).residual;
  result.by_paper = of_equal_distance(sliding_distance_paper, mass, resistance, F, result.sliding);
  result.by_exact = of_equal_distance(sliding_distance_exact, mass, resistance, F, result.sliding);
  if (ratio > 1.) result.by_excess = time_above(force, resistance) / (1. - 1. / ratio);
  result.by_impulse = 2. * impulse_of_lobe(force, peak) / F;
  return result;
}

namespace {

/// `relief`: change of N'.
Sliding slide_on(const BottomForces& forces, const BottomResistance& bottom, const History& relief) {
  return slide(bottom.mass, forces.shear_force, friction_of(bottom.friction, bottom.submerged_weight, relief),
               bottom.drag);
}

}  // namespace

Sliding slide_on_history(const BottomForces& forces, const BottomResistance& bottom) {
  return slide_on(forces, bottom, sum({}, -1., forces.uplift));
}

HistorySliding slide_history(const BottomForces& forces, const BottomResistance& bottom) {
  const History F_S = sum(forces.shear_force, bottom.friction, forces.uplift);
  const History less_uplift = sum({}, -1., forces.uplift);
  const History change = sum(less_uplift, 1., forces.normal_change);
  HistorySliding result;
  result.resistance = bottom.friction * bottom.submerged_weight;
  if (!F_S.value.empty()) {
    const std::size_t peak = peak_index(F_S);
    result.peak_force = F_S.value[peak];
    result.peak_force_time = F_S.time[peak];
    result.uplift_at_peak = value_at(forces.uplift, result.peak_force_time);
    result.shear_at_peak = result.peak_force - bottom.friction * result.uplift_at_peak;
    const History seaward = sum(negative(forces.shear_force), bottom.friction, forces.uplift);
    const std::size_t least = peak_index(seaward);
    result.peak_seaward = seaward.value[least];
    result.peak_seaward_time = seaward.time[least];
    const auto largest = [](const History& history) { return history.value[peak_index(history)]; };
    result.peak_on_normal = largest(sum(forces.shear_force, -bottom.friction, change));
    result.peak_seaward_on_normal = largest(sum(negative(forces.shear_force), -bottom.friction, change));
  }
  result.ratio = result.peak_force / result.resistance;
  result.least_normal_force = bottom.submerged_weight + least(change);
  result.by_history = slide_on(forces, bottom, less_uplift);
  result.with_normal_force = slide_on(forces, bottom, change);
  if (result.peak_force <= 0.) return result;
  result.own = history_duration(bottom.mass, F_S, result.ratio);
  for (const double r : {1.05, 1.1, 1.2, 1.3, 1.5, 1.75, 2.})
    result.table.push_back(history_duration(bottom.mass, F_S, r));
  return result;
}

}  // namespace upbead
