#include "upbead/sliding/duration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "upbead/sliding/pulse.h"

namespace upbead {

namespace {

using Distance = double (*)(double, double, const TriangularPulse&);

/// S of a pulse is proportional to tau_0^2.
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
double time_above(const ForceHistory& force, double level) {
  double sum = 0.;
  for (std::size_t i = 1; i < force.time.size(); ++i) {
    const Part part = part_above(force.value[i - 1], force.value[i], level);
    sum += (part.to - part.from) * (force.time[i] - force.time[i - 1]);
  }
  return sum;
}

/// Integral of F_S over one piece where it is above 0.
double positive_impulse(const ForceHistory& force, std::size_t i) {
  const double begin = force.value[i - 1], end = force.value[i];
  const Part part = part_above(begin, end, 0.);
  return 0.5 * (std::max(begin, 0.) + std::max(end, 0.)) * (part.to - part.from) * (force.time[i] - force.time[i - 1]);
}

/// Impulse from the last time before the peak at which F_S is not above 0 to the first one after it.
double impulse_of_lobe(const ForceHistory& force, std::size_t peak) {
  double sum = 0.;
  for (std::size_t i = peak; i > 0 && force.value[i] > 0.; --i) sum += positive_impulse(force, i);
  for (std::size_t i = peak + 1; i < force.time.size() && force.value[i - 1] > 0.; ++i)
    sum += positive_impulse(force, i);
  return sum;
}

}  // namespace

std::size_t peak_index(const ForceHistory& force) {
  return static_cast<std::size_t>(std::max_element(force.value.begin(), force.value.end()) - force.value.begin());
}

HistoryDuration history_duration(double mass, const ForceHistory& force, double ratio) {
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

}  // namespace upbead
