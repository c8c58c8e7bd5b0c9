// Whether the stages of a case build its section: every region once, nothing before what carries it.
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/text.h"
#include "fem/checker.h"
#include "fem/static_stage.h"

namespace upbead {

using namespace dealii;

namespace {

std::string key_of_stage(const std::string& stage, const std::string& key) {
  return "construction." + stage + "." + key;
}

/// The stage in which each region is built, and its place in their order.
struct Birth {
  std::string stage;
  std::size_t place = 0;
};
using Births = std::map<std::string, Birth>;

/// Regions that have weight and stiffness, so that they must be built.
Names to_be_built(const Checker& checker) {
  Names names;
  for (const auto& [name, region] : checker.scene.regions)
    if (region.kind != RegionKind::water && checker.outline.surfaces.count(name)) names.insert(name);
  return names;
}

void check_order(Checker& checker) {
  std::map<int, std::string> known;
  for (const auto& [name, stage] : checker.scene.construction)
    if (const auto [first, is_new] = known.emplace(stage.order, name); !is_new)
      checker.object(
          key_of_stage(name, "order"),
          "the stages '" + first->second + "' and '" + name + "' have the same order, " + std::to_string(stage.order),
          "number them in the order in which they are built, each once");
}

Births check_births(Checker& checker) {
  const Names wanted = to_be_built(checker);
  const std::vector<std::string> stages = stages_in_order(checker.scene);
  Births births;
  for (std::size_t k = 0; k < stages.size(); ++k)
    for (const std::string& region : checker.scene.construction.at(stages[k]).regions) {
      const std::string key = key_of_stage(stages[k], "regions");
      if (checker.is(region, RegionKind::water))
        checker.object(key, "the region '" + region + "' is water, which is always there", "remove it from the stage");
      else if (!wanted.count(region))
        checker.object(key, "there is no region '" + region + "' to build", "the regions are: " + list(wanted));
      else if (const auto [first, is_new] = births.emplace(region, Birth{stages[k], k}); !is_new)
        checker.object(key,
                       "the region '" + region + "' is built twice: in the stages '" + first->second.stage + "' and '" +
                           stages[k] + "'",
                       "keep it in one of them");
    }
  for (const std::string& region : wanted)
    if (!births.count(region))
      checker.object("construction", "the region '" + region + "' is never built",
                     "add it to the regions of a stage; the ground as it is found belongs to the first");
  return births;
}

/// Length by which a region lies on another one, over x; negative where the other lies on it.
std::map<std::pair<std::string, std::string>, double> overlaps(const Mesh& mesh) {
  std::map<std::pair<std::string, std::string>, double> length;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f)) continue;
      const std::string &own = mesh.surface_of(cell), &other = mesh.surface_of(cell->neighbor(f));
      if (own == other) continue;
      const Point<dim> a = cell->face(f)->vertex(0), b = cell->face(f)->vertex(1);
      const Tensor<1, dim> inward = cell->center() - cell->face(f)->center();
      const double run = b[0] - a[0], rise = b[1] - a[1];
      // the cell lies above the line of its face where its centre is to the left of the way along x
      const double side = run * inward[1] - rise * inward[0];
      length[{own, other}] += side * run > 0. ? std::abs(run) : -std::abs(run);
    }
  return length;
}

/// Nothing may be built before what it lies on.
void check_support(Checker& checker, const Births& births) {
  for (const auto& [pair, length] : overlaps(checker.mesh)) {
    const auto above = births.find(pair.first), below = births.find(pair.second);
    if (!(length > 0.) || above == births.end() || below == births.end()) continue;
    if (above->second.place < below->second.place)
      checker.object(key_of_stage(above->second.stage, "regions"),
                     "the region '" + pair.first + "' is built in the stage '" + above->second.stage +
                         "', before the region '" + pair.second + "', on which it lies, in the stage '" +
                         below->second.stage + "'",
                     "build '" + pair.second + "' in the same stage or an earlier one");
  }
}

/// Area of the caisson below a level (m2): of each cell the part of its polygon that is.
double area_below(const Mesh& mesh, double level) {
  constexpr std::array<unsigned, 4> around{0, 1, 3, 2};
  double area = 0.;
  if (std::isinf(level) && level < 0.) return area;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (mesh.surface_of(cell) != caisson_name) continue;
    double twice = 0.;  // of the area between the sides' parts below the level and that level
    for (std::size_t i = 0; i < around.size(); ++i) {
      Point<dim> a = cell->vertex(around[i]), b = cell->vertex(around[(i + 1) % around.size()]);
      if (std::isfinite(level)) {
        const auto cut = [&](const Point<dim>& low, const Point<dim>& high) {
          return low + (high - low) * ((level - low[1]) / (high[1] - low[1]));
        };
        if (a[1] > level && b[1] > level) continue;
        if (a[1] > level) a = cut(b, a);
        if (b[1] > level) b = cut(a, b);
      }
      const double top = std::isfinite(level) ? level : 0.;
      twice += (b[0] - a[0]) * (2. * top - a[1] - b[1]);
    }
    area += 0.5 * std::abs(twice);
  }
  return area;
}

/// Weight of the caisson in air (N/m), where the case tells it.
std::optional<double> weight_in_air(const Checker& checker) {
  const Region& caisson = checker.scene.regions.at(caisson_name);
  if (!caisson.mass && !caisson.density) return std::nullopt;
  return caisson.mass_over(area_below(checker.mesh, HUGE_VAL)) * checker.scene.gravity;
}

/// A caisson of less than its whole weight: it stands, it does not float, and it is full before the waves.
void check_caisson_shares(Checker& checker, const Births& births) {
  const auto birth = births.find(caisson_name);
  const double found_level = water_level(checker.scene, checker.mesh);
  const std::vector<std::string> stages = stages_in_order(checker.scene);
  double share = 1.;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const ConstructionStage& stage = checker.scene.construction.at(stages[k]);
    const bool stands = birth != births.end() && birth->second.place <= k;
    const std::string key = key_of_stage(stages[k], stage.caisson_share ? "caisson_share" : "water_level");
    if (stage.caisson_share && !stands)
      checker.object(key, "there is no caisson in the stage '" + stages[k] + "' yet",
                     "give its share in the stage that builds it, or later");
    if (!stands) continue;
    share = stage.caisson_share.value_or(share);
    const std::optional<double> weight = weight_in_air(checker);
    const double lift = checker.scene.fluid.density * checker.scene.gravity *
                        area_below(checker.mesh, stage.water_level.value_or(found_level));
    if (weight && share * *weight <= lift)
      checker.object(key,
                     "the caisson floats in the stage '" + stages[k] + "': " + percent(share) + " of its weight are " +
                         with_unit(share * *weight, "N/m") + ", and water lifts it by " + with_unit(lift, "N/m"),
                     "give more of its weight, or a lower water_level, in this stage");
  }
  if (share != 1.)
    checker.object(
        "construction",
        "the last stage leaves the caisson with " + percent(share) + " of its weight, and the waves meet the whole",
        "add a stage with caisson_share = 1");
}

/// Before the waves water stands where [initial] says.
void check_last_level(Checker& checker) {
  const std::string last = stages_in_order(checker.scene).back();
  const std::optional<double>& level = checker.scene.construction.at(last).water_level;
  const double before_waves = water_level(checker.scene, checker.mesh);
  if (level && *level != before_waves)
    checker.object(key_of_stage(last, "water_level"),
                   "in the last stage water stands at y = " + significant(*level, 6) + " m, and before the waves at " +
                       significant(before_waves, 6) + " m",
                   "remove it, or write [initial] water_level = " + significant(*level, 6));
}

}  // namespace

void check_construction(Checker& checker) {
  if (checker.scene.construction.empty()) return;
  check_order(checker);
  const Births births = check_births(checker);
  check_support(checker, births);
  check_caisson_shares(checker, births);
  check_last_level(checker);
  for (const auto& [name, side] : checker.scene.boundaries)
    if (side.spring)
      checker.object("boundaries." + name + ".spring",
                     "what springs of a side bear is not followed from stage to stage of [construction]",
                     "remove the springs, or the stages");
}

}  // namespace upbead
