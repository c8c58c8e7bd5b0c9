#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/compile.h"
#include "scene_warnings.h"

namespace upbead {

namespace {

/// Concrete, whatever the fill weighs: a rigid region has no stiffness of its own.
constexpr double youngs_modulus = 30e9, poissons_ratio = 0.2;
/// Crossings of the caisson by sound within which the error of peak F_T exceeds 2 %: docs/warnings.md.
constexpr double least_crossings = 4.;

struct Box {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300, area = 0.;
};

Box caisson_box(const Mesh& mesh) {
  Box box;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (mesh.surface_of(cell) != caisson_name) continue;
    box.area += cell->measure();
    for (const unsigned v : cell->vertex_indices()) {
      box.left = std::min(box.left, cell->vertex(v)[0]);
      box.right = std::max(box.right, cell->vertex(v)[0]);
      box.low = std::min(box.low, cell->vertex(v)[1]);
      box.high = std::max(box.high, cell->vertex(v)[1]);
    }
  }
  return box;
}

/// From where the first horizontal load on the caisson begins to where the last one has ended (s); infinite where one
/// lasts, as slow parts of a load make the peak of F_T even where it begins with a jump.
double time_of_loads(const Simulation& simulation) {
  double first = simulation.scene.time.end, last = 0.;
  for (std::size_t k = 0; k < simulation.compiled->loads_on_caisson.size(); ++k) {
    const TimeFunction& f = simulation.compiled->system.loads[k].history;
    if (!simulation.compiled->loads_on_caisson[k].arm() || f.kinks().empty()) continue;
    first = std::min(first, f.kinks().front());
    last = std::max(last, f(f.kinks().back() + 1.) == 0. ? f.kinks().back() : simulation.scene.time.end);
  }
  return last > first ? last - first : simulation.scene.time.end;
}

}  // namespace

NumberedWarnings load_warnings(const Simulation& simulation) {
  if (!simulation.compiled->caisson || !simulation.scene.time.inertia) return {};
  if (simulation.scene.regions.at(caisson_name).kind != RegionKind::rigid) return {};
  const Box box = caisson_box(*simulation.mesh);
  const double constrained =
      youngs_modulus * (1. - poissons_ratio) / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
  const double sound = std::sqrt(constrained * box.area / simulation.compiled->caisson->body.mass);
  const double limit = least_crossings * (box.right - box.left) / sound, time = time_of_loads(simulation);
  if (time >= limit) return {};
  return {{"fast_load", time, limit, "s",
           "the loads are over within " + significant(time) + " s, but sound takes " +
               significant(limit / least_crossings) + " s to cross the caisson (E = 30 GPa assumed, as it is rigid): " +
               "its own deformation changes peak F_T by 2 to 15 %; make it kind = \"solid\""}};
}

}  // namespace upbead
