#include "gauge_loads.h"

#include <algorithm>

#include "upbead/base/error.h"

namespace upbead {

namespace {

bool sees_any(const std::vector<double>& pressure) {
  return std::any_of(pressure.begin(), pressure.end(), [](double p) { return p != 0.; });
}

/// How many samples a run until `end` needs: one beyond it too.
std::ptrdiff_t needed(const std::vector<double>& time, double end) {
  const auto beyond = std::upper_bound(time.begin(), time.end(), end);
  return beyond - time.begin() + (beyond == time.end() ? 0 : 1);
}

}  // namespace

void add_gauge_loads(const std::string& name, const GaugeLoad& by_gauges, double end, Scene& scene) {
  const Gauges& gauges = by_gauges.gauges;
  const std::ptrdiff_t n = needed(gauges.time, end);
  const std::vector<double> time(gauges.time.begin(), gauges.time.begin() + n);
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    if (n < 2 || !sees_any(gauges.pressure[i])) continue;
    Load load = by_gauges.load;
    load.kind = LoadKind::pressure;
    load.shape = share(gauges, i);
    load.transducer = gauges.name[i];
    if (load.factor != 0.) {
      const std::vector<double> pressure(gauges.pressure[i].begin(), gauges.pressure[i].begin() + n);
      load.history = scaled(piecewise_linear(time, pressure), load.factor);
      load.duration = sampled_duration(time, pressure, end);
    }
    scene.loads[name + "." + load.transducer] = load;
  }
}

TimeFunction uplift_of(const GaugeLoad& by_gauges) {
  const auto [from, to] = *by_gauges.source.ends;
  std::vector<double> uplift = resultant(by_gauges.gauges, from, to).force;
  for (double& force : uplift) force = std::max(force, 0.);
  if (!sees_any(uplift))
    throw InputError({by_gauges.source.gauges}, "the transducers see no uplift", "give pressures upward as positive");
  return piecewise_linear(by_gauges.gauges.time, uplift);
}

}  // namespace upbead
