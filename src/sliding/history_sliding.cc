#include "upbead/sliding/history_sliding.h"

#include <algorithm>

#include "force_pieces.h"

namespace upbead {

namespace {

/// a + factor b, at the times of both; `b` without points is zero.
ForceHistory sum(const ForceHistory& a, double factor, const ForceHistory& b) {
  ForceHistory result;
  const auto add = [&result, factor](double t, double x, double y) {
    if (!result.time.empty() && result.time.back() == t && result.value.back() == x + factor * y) return;
    result.time.push_back(t);
    result.value.push_back(x + factor * y);
  };
  for (const detail::TwoLines& piece : detail::two_lines(a, b)) {
    add(piece.start, piece.first.begin, piece.second.begin);
    add(piece.start + piece.length, piece.first.end, piece.second.end);
  }
  return result;
}

/// factor (level + history), not below 0; exact where the line crosses 0.
ForceHistory friction_of(double factor, double level, const ForceHistory& history) {
  if (history.time.empty()) return {{0.}, {factor * level}};
  ForceHistory result{{history.time.front()}, {factor * level}};  // before the wave
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

double value_at(const ForceHistory& history, double t) {
  for (std::size_t i = 1; i < history.time.size(); ++i)
    if (history.time[i - 1] <= t && t <= history.time[i] && history.time[i - 1] < history.time[i]) {
      const double part = (t - history.time[i - 1]) / (history.time[i] - history.time[i - 1]);
      return (1. - part) * history.value[i - 1] + part * history.value[i];
    }
  return 0.;
}

double least(const ForceHistory& history) {
  return history.value.empty() ? 0. : std::min(0., *std::min_element(history.value.begin(), history.value.end()));
}

}  // namespace

HistorySliding slide_history(const BottomForces& forces, const BottomResistance& bottom) {
  const ForceHistory F_S = sum(forces.shear_force, bottom.friction, forces.uplift);
  const ForceHistory less_uplift = sum({}, -1., forces.uplift);
  const ForceHistory change = sum(less_uplift, 1., forces.normal_change);
  HistorySliding result;
  result.resistance = bottom.friction * bottom.buoyant_weight;
  if (!F_S.value.empty()) {
    const std::size_t peak = peak_index(F_S);
    result.peak_force = F_S.value[peak];
    result.peak_force_time = F_S.time[peak];
    result.uplift_at_peak = value_at(forces.uplift, result.peak_force_time);
    result.shear_at_peak = result.peak_force - bottom.friction * result.uplift_at_peak;
  }
  result.ratio = result.peak_force / result.resistance;
  result.least_normal_force = bottom.buoyant_weight + least(change);
  const auto slide_on = [&](const ForceHistory& relief) {
    return slide(bottom.mass, forces.shear_force, friction_of(bottom.friction, bottom.buoyant_weight, relief),
                 bottom.drag);
  };
  result.by_history = slide_on(less_uplift);
  result.with_normal_force = slide_on(change);
  if (result.peak_force <= 0.) return result;
  result.own = history_duration(bottom.mass, F_S, result.ratio);
  for (const double r : {1.05, 1.1, 1.2, 1.3, 1.5, 1.75, 2.})
    result.table.push_back(history_duration(bottom.mass, F_S, r));
  return result;
}

}  // namespace upbead
