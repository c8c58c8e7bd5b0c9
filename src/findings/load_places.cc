#include "findings/load_places.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/compile.h"
#include "response/shear_response.h"

namespace upbead {

namespace {

/// What the parts of a scene's load are in its system.
struct LoadPlace {
  bool on_caisson = false, on_free = false, prescribes = false;
};

LoadPlace place_of(const Simulation& simulation, const std::string& name) {
  const CompiledScene& compiled = *simulation.compiled();
  const System& system = compiled.system;
  LoadPlace place;
  for (std::size_t k = 0; k < system.loads.size(); ++k) {
    const SystemLoad& part = system.loads[k];
    if (part.name != name && part.name.rfind(name + ".", 0) != 0) continue;
    const LoadOnCaisson& on = compiled.loads_on_caisson[k];
    place.on_caisson = place.on_caisson || on.force_x != 0. || on.force_y != 0. || on.moment != 0.;
    place.prescribes = place.prescribes || part.prescribed >= 0;
    place.on_free = place.on_free || !part.vector.head(system.n_free()).isZero(0.);
  }
  return place;
}

template <class Visit>
void for_each_acting(const Scene& scene, const Visit& visit) {
  for (const auto& [name, load] : scene.loads)
    if (load.factor != 0.) visit(name, load);
}

}  // namespace

bool acts_elsewhere(const Simulation& simulation, const ShearResponse& response) {
  constexpr double trifle = 0.2;  // of F_T: one wave's pressures on wall and bed belong together
  const double P = std::max(response.peak_force, -response.peak_force_seaward),
               F_T = std::max(response.peak_shear, -response.peak_shear_seaward);
  bool found = false;
  for_each_acting(simulation.scene(), [&](const std::string& name, const Load& load) {
    const std::string wave = name.substr(0, name.find('.'));  // of a part on a curve of mound or bed
    found = found || is_motion(load.kind) || !place_of(simulation, wave).on_caisson;
  });
  return found && P <= trifle * F_T;
}

bool loads_go_on(const Simulation& simulation) {
  constexpr double counts = 0.05;
  const double end = simulation.scene().time.end;
  for (const SystemLoad& load : simulation.system().loads) {
    const auto range = [&](double from, double to) {
      return std::pair(extremum(load.history, from, to, -1).value, extremum(load.history, from, to, 1).value);
    };
    const auto [low, high] = range(0., end);
    const auto [least, largest] = range(end, 2. * end);
    if (largest - least > counts * std::max(std::abs(low), std::abs(high))) return true;
  }
  return false;
}

NumberedWarnings load_place_warnings(const Simulation& simulation) {
  NumberedWarnings list;
  if (!simulation.compiled()->caisson || simulation.processes()) return list;
  for_each_acting(simulation.scene(), [&](const std::string& name, const Load& load) {
    const LoadPlace place = place_of(simulation, name);
    if (is_motion(load.kind) || place.on_caisson || place.on_free || place.prescribes) return;
    list.push_back(
        {"load_zero", 0., 0., "",
         "'loads." + name + "' acts on '" + load.boundary + "', which is held in that direction: nothing of it is felt",
         "name the boundary that the wave presses on, as \"front\", the caisson's seaward wall", true});
  });
  const auto& sliding = simulation.scene().sliding;
  if (!sliding || !sliding->uplift || sliding->uplift->kind != UpliftKind::prescribed || !sliding->uplift->peak)
    return list;
  const double end = simulation.scene().time.end;
  const TimeFunction P = force_on_caisson(*simulation.compiled());
  if (extremum(P, 0., end, 1).value > 0. || extremum(P, 0., end, -1).value < 0. || simulation.scene().loads.empty())
    return list;
  list.push_back(
      {"uplift_left_out", *sliding->uplift->peak, 0., "N/m",
       "the prescribed uplift follows the force of loads on the caisson, and none acts there: of its peak of " +
           with_unit(*sliding->uplift->peak, "N/m") + " nothing acts",
       "give the uplift over time (sliding.uplift.history), or kind = \"computed\"", true});
  return list;
}

}  // namespace upbead
