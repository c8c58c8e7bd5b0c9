#include "findings/border_warnings.h"

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/compile.h"
#include "fem/static_stage.h"
#include "findings/support_warnings.h"

namespace upbead {

namespace {

/// An outer curve: lengths of what faces up and down and of all (m), and what is behind it.
struct OuterBorder {
  double up = 0., down = 0., length = 0., lowest = infinity;
  std::set<RegionKind> kinds;
  bool has_pore_water = false;
  double modulus = infinity;  ///< least G of soil behind it (Pa)

  bool faces_up() const { return 2. * up > length; }
  bool faces_down() const { return 2. * down > length; }
  bool is_soil() const { return kinds.count(RegionKind::porous) + kinds.count(RegionKind::solid) > 0; }
  bool is_water() const { return kinds == std::set{RegionKind::water}; }
};

/// G (Pa), of a law of stress that at its reference; 0 of what is no soil.
double shear_modulus_of(const Region& region) {
  if (region.stress_law) return region.stress_law->reference;
  if (region.shear_modulus) return *region.shear_modulus;
  return region.youngs_modulus ? *region.youngs_modulus / (2. * (1. + region.poissons_ratio.value_or(0.))) : 0.;
}

std::map<std::string, OuterBorder> borders_of(const Simulation& simulation) {
  constexpr double level = 0.7;  // of a normal: slopes up to 45 degrees
  const Mesh& mesh = *simulation.mesh();
  std::map<std::string, OuterBorder> borders;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const auto region = simulation.scene().regions.find(mesh.surface_of(cell));
    if (region == simulation.scene().regions.end() || region->first == caisson_name) continue;
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || mesh.curve_of(face).empty()) continue;
      const double length = face->measure(), across = std::abs(face->vertex(1)[0] - face->vertex(0)[0]);
      const bool up = face->center()[1] > cell->center()[1];
      OuterBorder& border = borders[mesh.curve_of(face)];
      border.length += length;
      if (across > level * length) (up ? border.up : border.down) += length;
      border.lowest = std::min({border.lowest, face->vertex(0)[1], face->vertex(1)[1]});
      border.kinds.insert(region->second.kind);
      if (const double G = shear_modulus_of(region->second); G > 0.) border.modulus = std::min(border.modulus, G);
      border.has_pore_water =
          border.has_pore_water || (region->second.kind == RegionKind::porous && region->second.flow != Flow::drained);
    }
  }
  return borders;
}

NumberedWarning about(const std::string& warning, const std::string& curve, double length, const std::string& what,
                      const std::string& cure, bool voids) {
  return {warning, length, 0., "m", "'" + curve + "', " + significant(length, 3) + " m of " + what, cure, voids};
}

NumberedWarnings warnings_of_top(const std::string& curve, const OuterBorder& border, const Boundary& given,
                                 double water) {
  NumberedWarnings list;
  const std::string at = "boundaries." + curve;
  const bool sealed = given.pressure && *given.pressure == PressureCondition::sealed;
  if (border.is_water() && sealed)
    list.push_back(about("sea_sealed", curve, border.length,
                         "the upper border of free water, is sealed: a lid that keeps the sea from rising holds the "
                         "caisson through its walls",
                         "write " + at + ".pressure = \"open\", or \"surface_waves\"", true));
  if (border.has_pore_water && sealed && border.lowest < water)
    list.push_back(about("ground_sealed", curve, border.length,
                         "the surface of ground under water, is sealed: its pores cannot give water off into the sea",
                         "write " + at + ".pressure = \"open\", unless something tight covers the ground", false));
  if (border.is_soil() && given.displacement != DisplacementCondition::free)
    list.push_back(about("ground_held", curve, border.length, "the surface of the ground, is held",
                         "remove " + at + ".displacement", false));
  return list;
}

/// Whether a condition, or springs and dashpots along the normal that are not trifling beside ground of that height,
/// bear it.
bool bears(const Boundary& given, const OuterBorder& border, double height) {
  constexpr double share = 0.1, light = 1500.;  // kg/m3, of soil
  return given.displacement != DisplacementCondition::free ||
         (given.spring && (*given.spring)[0] >= share * border.modulus / height) ||
         (given.dashpot && (*given.dashpot)[0] >= share * std::sqrt(light * border.modulus));
}

}  // namespace

NumberedWarnings border_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (!simulation.compiled()->caisson) return {};
  const double water = water_level(scene, *simulation.mesh());
  NumberedWarnings list;
  for (const auto& [curve, border] : borders_of(simulation)) {
    const auto found = scene.boundaries.find(curve);
    const Boundary given = found == scene.boundaries.end() ? Boundary() : found->second;
    const double height = simulation.compiled()->caisson->bottom_centre[1] - border.lowest;  // a deck on it has none
    if (border.faces_down() && border.is_soil() && height > 0. && !bears(given, border, height) &&
        !is_moved(scene, curve))
      list.push_back(about("base_free", curve, border.length,
                           "the lower border of the ground, is free: nothing bears the ground there, so that it floats "
                           "under the caisson, and what presses on it carries nothing",
                           "write boundaries." + curve +
                               ".displacement = \"fixed\", or \"absorbing\" where the ground "
                               "goes on below",
                           true));
    if (border.faces_up()) append(list, warnings_of_top(curve, border, given, water));
  }
  return list;
}

}  // namespace upbead
