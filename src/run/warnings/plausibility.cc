#include "run/warnings/plausibility.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/compile.h"
#include "run/sliding/effective_base.h"

namespace upbead {

namespace {

/// A unit in which a number may have been given, and its value in SI.
struct MeantUnit {
  const char* name;
  double factor;
};

/// Generous bounds of a quantity: outside them a unit was mistaken, or the scene is no breakwater. And narrower,
/// common bounds, by which the unit is guessed.
struct Usual {
  const char* unit;
  double low, high, common_low, common_high;
  std::vector<MeantUnit> meant;
};

// Modulus: from mud to steel. Density: from light fills to steel. Conductivity or permeability: from clay to rock
// armour. Water: fresh to heavy sea water. mu: of base plates.
const Usual modulus{"Pa", 1e4, 1e12, 1e6, 3e11, {{"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}};
const Usual density{"kg/m3", 500., 2e4, 1e3, 8e3, {{"t/m3", 1e3}, {"kN/m3", 1e3 / 9.81}}};
const Usual water_density{"kg/m3", 900., 1300., 990., 1050., {{"t/m3", 1e3}, {"kN/m3", 1e3 / 9.81}}};
const Usual seepage{"m/s", 1e-13, 10., 1e-12, 0.5, {{"cm/s", 1e-2}, {"m/day", 1. / 86400.}, {"mm/s", 1e-3}}};
const Usual intrinsic{"m2", 1e-20, 1e-6, 1e-19, 5e-8, {{"darcy", 9.87e-13}, {"cm2", 1e-4}}};
const Usual friction{"1", 0.1, 1.5, 0.2, 1., {{"percent", 1e-2}}};

void judge(const std::string& key, const std::optional<double>& value, const Usual& usual, NumberedWarnings& list) {
  if (!value || (*value >= usual.low && *value <= usual.high)) return;
  std::string text =
      key + " = " + significant(*value, 4) + (usual.unit == std::string("1") ? "" : " " + std::string(usual.unit));
  text += *value < usual.low ? " is less than is ever found (" : " is more than is ever found (";
  const double limit = *value < usual.low ? usual.low : usual.high;
  text += significant(limit) + ")";
  for (const MeantUnit& unit : usual.meant)
    if (const double meant = *value * unit.factor; meant >= usual.common_low && meant <= usual.common_high) {
      text += "; if it was meant in " + std::string(unit.name) + ", write " + significant(meant, 4);
      break;
    }
  list.push_back({"implausible", *value, limit, usual.unit, text});
}

void judge_weight(const Simulation& simulation, NumberedWarnings& list) {
  const auto& sliding = simulation.scene.sliding;
  if (!sliding || !simulation.compiled->caisson) return;
  const double given = sliding->submerged_weight;
  const double in_air = simulation.compiled->caisson->body.mass * simulation.scene.gravity;
  const std::optional<double> in_water = weight_in_water(simulation);
  if (!in_water) {
    if (given < 0.99 * in_air)
      list.push_back({"no_water", given, in_air, "N/m",
                      "sliding.submerged_weight = " + significant(given, 4) + " N/m is below the weight in air, " +
                          significant(in_air, 4) +
                          " N/m, but the scene has no still water: give regions of water, or [initial] water_level"});
    return;
  }
  constexpr double tolerable = 0.1;  // footings, rounded corners and layers of ballast are less than a tenth of W'
  if (std::abs(given - *in_water) <= tolerable * std::abs(*in_water)) return;
  std::string text = "sliding.submerged_weight = " + significant(given, 4) + " N/m, but the caisson less the water " +
                     "that it displaces weighs " + significant(*in_water, 4) + " N/m";
  for (const MeantUnit& unit : {MeantUnit{"kN/m", 1e3}, MeantUnit{"MN/m", 1e6}})
    if (std::abs(given * unit.factor - *in_water) <= 0.3 * *in_water)
      text += "; if it was meant in " + std::string(unit.name) + ", write " + significant(given * unit.factor, 4);
  list.push_back({"submerged_weight", given, *in_water, "N/m", text});
}

}  // namespace

NumberedWarnings plausibility_warnings(const Simulation& simulation) {
  NumberedWarnings list;
  const Scene& scene = simulation.given;
  judge("fluid.density", scene.fluid.density, water_density, list);
  for (const auto& [name, region] : scene.regions) {
    const std::string at = "regions." + name + ".";
    judge(at + "shear_modulus", region.shear_modulus, modulus, list);
    judge(at + "youngs_modulus", region.youngs_modulus, modulus, list);
    judge(at + "density", region.density, density, list);
    judge(at + "grain_density", region.grain_density, density, list);
    judge(at + "hydraulic_conductivity", region.hydraulic_conductivity, seepage, list);
    judge(at + "permeability", region.permeability, intrinsic, list);
    if (region.porosity && region.biot < *region.porosity)
      list.push_back({"biot_below_porosity", region.biot, *region.porosity, "1",
                      at + "biot = " + significant(region.biot) + " is less than the porosity, " +
                          significant(*region.porosity) +
                          ", which no grains that fill the skeleton alone can have: the pore pressure counts for less "
                          "than it is"});
    if (region.interface) judge(at + "interface.coefficient", region.interface->coefficient, friction, list);
  }
  if (const int n = simulation.mesh->n_divided_triangles; n > 0)
    list.push_back({"triangles_divided", static_cast<double>(n), 0., "1",
                    std::to_string(n) +
                        " triangles of the mesh were divided into three quadrilaterals each, and its "
                        "quadrilaterals into four: " +
                        std::to_string(simulation.mesh->triangulation.n_active_cells()) +
                        " cells; quadrilaterals from the start need fewer unknowns: transfinite blocks with Recombine "
                        "Surface, or Mesh.SubdivisionAlgorithm = 1"});
  constexpr double straight = 1e-6;
  if (const double bent = simulation.mesh->most_bent; bent > straight)
    list.push_back({"sides_straightened", bent, straight, "1",
                    "cells of second order have curved sides, up to " + percent(bent) +
                        " of a side's length from its chord; they are read by their corners, with straight sides: use "
                        "more cells along curved boundaries"});
  if (scene.sliding) judge("sliding.friction", scene.sliding->friction, friction, list);
  judge_weight(simulation, list);
  return list;
}

}  // namespace upbead
