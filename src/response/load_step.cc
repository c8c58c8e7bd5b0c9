#include "response/load_step.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace upbead {

namespace {

struct LoadDuration {
  double seconds = infinity;
  std::string load;
  void consider(double other, const std::string& name) {
    if (other < seconds) *this = {other, name};
  }
};

/// The shortest duration of the loads of a scene in which a load jumps; a jump itself has no duration, so infinity
/// where there is only a jump.
LoadDuration duration_beside_jumps(const Scene& scene) {
  LoadDuration shortest;
  std::vector<std::pair<double, std::string>> kinks;
  for (const auto& [name, load] : scene.loads) {
    if (load.factor == 0.) continue;
    if (load.duration && *load.duration > 0.) shortest.consider(*load.duration, name);
    for (double kink : load.history.kinks()) kinks.emplace_back(kink, name);
  }
  std::sort(kinks.begin(), kinks.end());
  for (std::size_t i = 0; i + 1 < kinks.size(); ++i) {
    const double distance = kinks[i + 1].first - kinks[i].first;
    if (distance > 1e-9 * scene.time.end) shortest.consider(2. * distance, kinks[i + 1].second);
  }
  return shortest;
}

LoadDuration shortest_load(const Scene& scene) {
  const double seconds = shortest_duration(scene);
  if (!(seconds > 0.)) return duration_beside_jumps(scene);
  for (const auto& [name, load] : scene.loads) {
    Scene alone;
    alone.loads[name] = load;
    if (shortest_duration(alone) == seconds) return {seconds, name};
  }
  return {};
}

/// Growth from the last kink on, if all loads keep their values from there.
std::optional<StepGrowth> growth(const Scene& scene, double step) {
  const double end = scene.time.end;
  if (scene.time.growth == 1.) return {};
  StepGrowth growth{0., end / 50., scene.time.growth};
  for (const auto& [name, load] : scene.loads)
    for (double kink : load.history.kinks())
      if (kink < end) growth.after = std::max(growth.after, kink);
  for (const auto& [name, load] : scene.loads)
    if (!keeps_value(load.history, growth.after, std::min(step, (end - growth.after) / 8.))) return {};
  return growth;
}

}  // namespace

double step_fraction(const Scene& scene, int order) {
  const auto caisson = scene.regions.find(caisson_name);
  const bool gaps =
      caisson != scene.regions.end() && caisson->second.interface && caisson->second.interface->gap == GapSource::sea;
  constexpr double of_gaps = 0.125;  // the water of a gap is that of the step before it, of order 1: 5 % of S without
  return (gaps ? of_gaps : 1.) * (order >= 4 ? 1. / 8. : 1. / 64.) * std::pow(scene.tolerance / 0.005, 1. / order);
}

LoadStep step_of_loads(const Scene& scene, int order) {
  const double end = scene.time.end;
  const LoadDuration shortest = shortest_load(scene);
  LoadStep choice;
  choice.lone_jump = shortest.seconds == infinity && shortest_duration(scene) == 0.;
  choice.duration = choice.lone_jump ? end / 20. : std::min(shortest.seconds, end);
  if (shortest.seconds <= end) choice.load = shortest.load;
  choice.largest_step = std::min(step_fraction(scene, order) * choice.duration, end);
  if (!scene.time.inertia) choice.growth = growth(scene, choice.largest_step);
  return choice;
}

}  // namespace upbead
