// Where a load by a wave, its section and its uplift are not those of the meshed scene.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "findings/effective_base.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// Warning centroid_differs: W' of [section] acts on another line than the weight of the meshed caisson in water, so
/// that overturning and edge pressures by formulas are those of another caisson than the run's.
NumberedWarnings centroid_warnings(const Case& input, const Simulation& simulation) {
  constexpr double same = 0.02;  // of B: footings and rounded corners
  const Section& section = acting_waves(input).front()->section;
  const double B = section.width, t = section.centroid.value_or(0.5 * B);
  const std::optional<double> e = eccentricity_in_water(simulation);
  if (!e || std::abs(0.5 * B - *e - t) <= same * B) return {};
  return {{"centroid_differs", t, 0.5 * B - *e, "m",
           "by [section] W' acts " + significant(t, 4) + " m from the landward heel" +
               (section.centroid ? "" : ", as centroid is not given") + ", by the meshed caisson in still water " +
               significant(0.5 * B - *e, 4) +
               " m: overturning and edge pressures by formulas and by dynamics are of two caissons",
           "give section.centroid = " + significant(0.5 * B - *e, 4) + ", or mend the caisson's centre of gravity"}};
}

/// What of the meshed ground is seaward of the caisson's wall: height of its surface at the wall, and how far it stays
/// there (m).
struct MeshedBerm {
  double height = 0., width = 0.;
};

std::optional<MeshedBerm> meshed_berm(const Simulation& simulation) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const Mesh& mesh = *simulation.mesh();
  const double B = caisson.bottom_width, wall = caisson.bottom_centre[0] - 0.5 * B, hair = 0.01 * B;
  const auto is_ground = [&](const auto& cell) {
    const std::string& name = mesh.surface_of(cell);
    const RegionKind kind = simulation.scene().regions.at(name).kind;
    return name != caisson.body.region && (kind == RegionKind::porous || kind == RegionKind::solid);
  };
  std::map<double, double> surface;  // y by distance from the wall
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      const auto face = cell->face(f);
      if (!is_ground(cell) || face->center()[1] <= cell->center()[1] || face->center()[0] >= wall) continue;
      if (!cell->at_boundary(f) && is_ground(cell->neighbor(f))) continue;
      for (const unsigned v : {0U, 1U}) surface[wall - face->vertex(v)[0]] = face->vertex(v)[1];
    }
  if (surface.empty() || surface.begin()->first > hair) return std::nullopt;
  MeshedBerm berm{surface.begin()->second, 0.};
  for (const auto& [away, y] : surface) {
    if (std::abs(y - berm.height) > hair) break;
    berm.width = away;
  }
  return berm;
}

/// Warning berm_differs: Goda's formulas are asked about another berm than is meshed. Armour that is not meshed makes
/// the water over it shallower, never deeper, so that a deeper berm is a mistake, and P too small.
NumberedWarnings berm_warnings(const Case& input, const Simulation& simulation) {
  constexpr double same = 0.1;  // of the meshed one
  const Section& section = acting_waves(input).front()->section;
  const std::optional<MeshedBerm> berm = meshed_berm(simulation);
  if (!berm) return {};
  const double depth = section.foundation_depth - (berm->height - simulation.compiled()->caisson->bottom_centre[1]);
  NumberedWarnings list;
  const auto add = [&](const char* key, double given, double meshed, bool voids) {
    list.push_back({"berm_differs", given, meshed, "m",
                    std::string("section.") + key + " = " + significant(given, 4) + " m, of the meshed mound " +
                        significant(meshed, 4) + " m: alpha_2, alpha_I and P are those of another mound",
                    "give one mound in both", voids});
  };
  if (depth > 0. && section.berm_depth > (1. + same) * depth) add("berm_depth", section.berm_depth, depth, true);
  if (std::abs(section.berm_width - berm->width) > same * berm->width)
    add("berm_width", section.berm_width, berm->width, false);
  return list;
}

/// Whether one of these curves meets the foot of a wall of the caisson, so that a pressure on it gets under the base.
bool reaches_foot(const Simulation& simulation, const std::vector<std::string>& curves) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const Mesh& mesh = *simulation.mesh();
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary()) continue;
      if (std::find(curves.begin(), curves.end(), mesh.curve_of(face)) == curves.end()) continue;
      for (const unsigned v : {0U, 1U}) {
        const auto from = face->vertex(v) - caisson.bottom_centre;
        if (std::hypot(std::abs(from[0]) - 0.5 * caisson.bottom_width, from[1]) < 1e-6 * caisson.bottom_width)
          return true;
      }
    }
  return false;
}

/// Warning uplift_left_out: a wave presses on the wall alone, and nothing lifts the caisson.
NumberedWarnings warnings_of_no_uplift(const Case& input, const Simulation& simulation) {
  const auto& sliding = input.scene.sliding;
  const bool is_given = sliding && sliding->uplift && sliding->uplift->kind != UpliftKind::computed;
  if (is_given) return {};
  for (const WaveLoad* wave : acting_waves(input)) {
    if (reaches_foot(simulation, wave->table.mound) || !(wave->pressure.uplift > 0.)) continue;
    const std::string U = with_unit(wave->pressure.uplift, "N/m");
    return {{"uplift_left_out", wave->pressure.uplift, 0., "N/m",
             std::string("the load by a wave presses ") +
                 (wave->table.mound.empty() ? "on the wall alone" : "on no curve of mound or bed at the wall's foot") +
                 ", and " +
                 std::string(sliding && sliding->uplift ? "the computed uplift is that of the caisson's own motion"
                                                        : "no uplift acts") +
                 ": S, N', pressures and margins of the run lack the wave's uplift, by Goda " + U,
             std::string(sliding ? "" : "add [sliding] with friction and submerged_weight; ") +
                 "write sliding.uplift = { kind = \"wave\" }, or, with kind = \"computed\", name the curves of mound "
                 "and bed "
                 "in [loads.NAME.wave] mound"}};
  }
  return {};
}

/// Largest U (N/m) of the loads by waves by their own formulas.
double uplift_of_waves(const Case& input) {
  double largest = 0.;
  const std::vector<const WaveLoad*> waves = acting_waves(input);
  for (const auto& [name, source] : input.sources)
    for (const WaveLoad* wave : waves)
      if (wave == source.get()) largest = std::max(largest, input.scene.loads.at(name).factor * wave->pressure.uplift);
  return largest;
}

/// Least T (s) of the loads by waves.
double period_of_waves(const Case& input) {
  double least = infinity;
  for (const WaveLoad* wave : acting_waves(input)) least = std::min(least, wave->wave.period);
  return least;
}

/// Warning uplift_differs: beside a load by a wave the case prescribes an uplift that is smaller than the wave's own,
/// or comes after its force.
NumberedWarnings warnings_of_other_uplift(const Case& input) {
  constexpr double as_large = 0.8, at_once = 0.02;  // of a period
  const auto& sliding = input.scene.sliding;
  const Node* kind = input.document.find("sliding.uplift.kind");
  const std::string* word = kind ? std::get_if<std::string>(&kind->value) : nullptr;
  if (!sliding || !sliding->uplift || sliding->uplift->kind != UpliftKind::prescribed || (word && *word == "wave"))
    return {};
  const UpliftChoice& uplift = *sliding->uplift;
  const double of_waves = uplift_of_waves(input), end = input.scene.time.end,
               given = uplift.peak ? *uplift.peak : extremum(uplift.history, 0., end, 1).value;
  const bool is_small = given < as_large * of_waves;
  const bool is_late = uplift.lag > at_once * period_of_waves(input);
  if (!(of_waves > 0.) || !uplift.parts.empty() || !(is_small || is_late)) return {};
  return {{"uplift_differs", given, of_waves, "N/m",
           "the prescribed uplift " +
               (is_small ? "has a peak of " + with_unit(given, "N/m") + ", the wave by its own formula " +
                               with_unit(of_waves, "N/m")
                         : "comes " + significant(uplift.lag, 3) +
                               " s after the wave's force, and by its own formula with it") +
               ": S, N' and margins of the run are those of less uplift than the checks by formulas have",
           "write sliding.uplift = { kind = \"wave\" }, unless this uplift was measured"}};
}

}  // namespace

NumberedWarnings wave_mesh_warnings(const Case& input, const Simulation& simulation) {
  if (!simulation.compiled()->caisson || acting_waves(input).empty()) return {};
  NumberedWarnings list = centroid_warnings(input, simulation);
  append(list, berm_warnings(input, simulation));
  append(list, warnings_of_no_uplift(input, simulation));
  append(list, warnings_of_other_uplift(input));
  return list;
}

}  // namespace upbead
