// Whether the numbers of a scene are those of breakwaters, and in which unit they may have been meant.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/compile.h"
#include "findings/effective_base.h"
#include "findings/finding.h"
#include "findings/plausibility.h"
#include "model/quantities.h"

namespace upbead {

double stiffness_of(const Region& region) {
  if (region.shear_modulus) return *region.shear_modulus;
  if (region.stress_law) return region.stress_law->reference;
  return region.youngs_modulus.value_or(0.) / 3.;
}

void judge_weight(const std::string& key, double given, const Simulation& simulation, NumberedWarnings& list) {
  const double in_air = simulation.compiled()->caisson->body.mass * simulation.scene().gravity;
  const std::optional<double> in_water = weight_in_water(simulation);
  if (!in_water) {
    if (given < 0.99 * in_air)
      list.push_back({"no_water", given, in_air, "N/m",
                      key + " = " + significant(given, 4) + " N/m is below the weight in air, " +
                          significant(in_air, 4) + " N/m, but the scene has no still water",
                      "give regions of water, or [initial] water_level"});
    return;
  }
  // footings, rounded corners and layers of ballast are less than a tenth of W'; more than it is a safety that is not
  constexpr double tolerable = 0.1, unsafe = 0.02;
  const double difference = given - *in_water, size = std::abs(*in_water);
  if (difference <= unsafe * size && difference >= -tolerable * size) return;
  const std::string text = key + " = " + significant(given, 4) + " N/m, but the caisson less the water " +
                           "that it displaces weighs " + significant(*in_water, 4) + " N/m";
  std::string cure;
  for (const MeantUnit& unit :
       {MeantUnit{"kN/m", 1e3}, MeantUnit{"MN/m", 1e6}, MeantUnit{"t/m", 9.81e3}, MeantUnit{"kg/m", 9.81}})
    if (std::abs(unit.in_si(given) - *in_water) <= 0.3 * *in_water)
      cure += (cure.empty() ? "" : "; ") + cure_of_unit(unit, unit.in_si(given));
  if (cure.empty()) cure = "check submerged_weight, the mass of the caisson and the level of still water";
  list.push_back({"submerged_weight", given, *in_water, "N/m", text, cure, std::abs(difference) > tolerable * size});
}

namespace {

/// Viscosity and the air's pressure only where a region uses them: `upbead scale` scales both.
void judge_fluid(const Scene& scene, NumberedWarnings& list) {
  const Fluid& fluid = scene.fluid;
  const auto any = [&](const auto& uses) {
    return std::any_of(scene.regions.begin(), scene.regions.end(), [&](const auto& r) { return uses(r.second); });
  };
  judge("fluid.density", fluid.density, quantities::water_density, list);
  judge("fluid.bulk_modulus", fluid.bulk_modulus, quantities::water_modulus, list);
  if (any([](const Region& region) { return region.permeability.has_value(); }))
    judge("fluid.viscosity", fluid.viscosity, quantities::viscosity, list);
  if (any([](const Region& region) { return region.saturation < 1.; }))
    judge("fluid.atmospheric_pressure", fluid.atmospheric_pressure, quantities::atmosphere, list);
}

/// The strain at which a table of G over strain falls to half; none where it does not.
std::optional<double> half_strain(const StrainLaw& law) {
  for (std::size_t i = 1; i < law.modulus.size(); ++i) {
    const auto [strain_0, ratio_0] = law.modulus[i - 1];
    const auto [strain_1, ratio_1] = law.modulus[i];
    if (ratio_0 >= 0.5 && ratio_1 < 0.5)
      return strain_0 * std::pow(strain_1 / strain_0, (ratio_0 - 0.5) / (ratio_0 - ratio_1));
  }
  return std::nullopt;
}

/// Stiffness falls with the strain, damping rises (side: -1, 1; Seed and Idriss 1970): columns may be mixed up.
void judge_course(const std::string& key, const std::string& what, const std::vector<std::array<double, 2>>& table,
                  double side, NumberedWarnings& list) {
  constexpr double scatter = 0.02;  // of measured points
  for (std::size_t i = 1; i < table.size(); ++i) {
    const double before = table[i - 1][1], value = table[i][1];
    if (side * (value - before) >= -scatter * std::max(value, before)) continue;
    list.push_back({"implausible", value, before, "1",
                    key + ": " + what + (side < 0. ? " rises" : " falls") + " from " + significant(before) + " to " +
                        significant(value) + " at a strain of " + significant(table[i][0]) + ", and that of soil " +
                        (side < 0. ? "falls" : "rises") + " with the strain",
                    "give pairs (strain, value) of one curve", true});
    return;
  }
}

void judge_strain_law(const std::string& at, const StrainLaw& law, NumberedWarnings& list) {
  const Quantity effective{"1", 0.1, 1.01, 0.4, 1., {{"percent", 1e-2}}, "0.65 is usual"};
  judge(at + "effective", law.effective, effective, list);
  judge(at + "modulus, the strain at half of G", half_strain(law), quantities::reference_strain, list);
  judge_course(at + "modulus", "G/G_max", law.modulus, -1., list);
  judge_course(at + "damping", "the damping ratio", law.damping, 1., list);
  double largest = 0.;
  for (const auto& [strain, ratio] : law.damping) largest = std::max(largest, ratio);
  judge(at + "damping, its largest ratio", largest, quantities::largest_damping, list);
}

/// The damping that two frequencies give where the motion is: its least between the length of the run and the faster of
/// the shortest load and a shear wave that passes a caisson of the width B.
void judge_damping(const std::string& at, const Region& region, const Scene& scene, double B, NumberedWarnings& list) {
  const Rayleigh& damping = *region.damping;
  judge(at + "damping.ratio", damping.ratio, quantities::damping, list);
  const double duration = shortest_duration(scene), slow = 1. / scene.time.end;
  if (!(duration > 0.) || !std::isfinite(duration)) return;
  const double G = stiffness_of(region);
  const double wave = B > 0. ? std::sqrt(G / 2e3) / (2. * B) : 0.;  // of 2 t/m3
  const double f = std::clamp(std::sqrt(damping.frequencies[0] * damping.frequencies[1]), slow,
                              std::max({slow, wave, 0.5 / duration}));
  const double ratio = damping.ratio_at(f);
  if (ratio > quantities::damping.high && damping.ratio <= quantities::damping.high)
    list.push_back({"implausible", ratio, quantities::damping.high, "1",
                    at + "damping: at " + significant(f) + " Hz, where the motion is, the ratio is " +
                        significant(ratio) + ", more than soil has",
                    "look at damping.frequencies (Hz), between which the ratio is that of damping.ratio", true});
}

/// C1 = 7600 (100 D_r)^-2.5 of D_r = 1 to 0.2 is 0.08 to 4.2, C2 = 0.4/C1 (Byrne 1991).
void judge_densification(const std::string& at, const Densification& law, NumberedWarnings& list) {
  judge(at + "threshold", law.threshold, quantities::threshold_strain, list);
  judge(at + "c1", law.c1, {"1", 0.03, 10., 0.05, 6., {{"percent", 1e-2}}, "sand has 0.1 to 4"}, list);
  judge(at + "c2", law.c2, {"1", 0.03, 15., 0.06, 8., {{"percent", 1e-2}}, "sand has 0.1 to 4"}, list);
}

/// Cohesion of the softest mud alone, where no friction helps, is some 500 Pa; and c'/G is the strain at which soil
/// fails: of clays 1/1000 to 1/50, of rock less.
void judge_strength(const std::string& at, const Strength& strength, double G, NumberedWarnings& list) {
  constexpr double none = 0.15, mud = 300., strain = 0.1;  // degrees: a small angle in place of zero; Pa
  const bool rubs = strength.friction_angle > none;
  if (rubs) judge(at + "friction_angle", strength.friction_angle, quantities::friction_angle, list);
  Quantity cohesion = quantities::cohesion;
  if (!rubs) cohesion.low = mud;
  if (G > 0.) cohesion.high = std::clamp(strain * G, 10. * cohesion.low, cohesion.high);
  judge(at + "cohesion", strength.cohesion, cohesion, list);
  judge(at + "dilatancy_angle", strength.dilatancy_angle,
        {"degrees", 0.5, 40., 1., 25., {{"radians", 180. / pi}}, "dense sand has 5 to 15"}, list);
  judge(at + "tension", strength.tension,
        {"Pa", 50., 1e8, 500., 2e7, quantities::cohesion.meant, "cemented soil has 1e3 to 1e5"}, list);
}

void judge_soil(const std::string& at, const Region& region, const Scene& scene, double B, NumberedWarnings& list) {
  if (region.densification) judge_densification(at + "densification.", *region.densification, list);
  if (region.damping) judge_damping(at, region, scene, B, list);
  if (const auto& law = region.stress_law) {
    judge(at + "shear_modulus.reference", law->reference, quantities::modulus, list);
    judge(at + "shear_modulus.pressure", law->pressure, quantities::stress_scale, list);
    Quantity floor = quantities::stress_scale;
    floor.low = floor.common_low = 1e-6;
    judge(at + "shear_modulus.floor", law->floor, floor, list);
  }
  if (const auto& law = region.strain_law) {
    judge_strain_law(at + "strain.", *law, list);
    judge(at + "strain.reference_strain", law->reference_strain, quantities::reference_strain, list);
    judge(at + "strain.smallest_damping", law->smallest_damping, quantities::smallest_damping, list);
    judge(at + "strain.largest_damping", law->largest_damping, quantities::largest_damping, list);
  }
  if (region.strength) judge_strength(at + "strength.", *region.strength, stiffness_of(region), list);
}

void judge_pores(const std::string& at, const Region& region, NumberedWarnings& list) {
  constexpr double rock = 1e9, coarse = 1e-5;  // Pa, m/s
  if (region.kind != RegionKind::porous) return;
  const auto k = region.hydraulic_conductivity;
  const double G = region.shear_modulus.value_or(region.youngs_modulus.value_or(0.));
  judge(at + "porosity", region.porosity,
        G >= rock           ? quantities::porosity
        : k && *k >= coarse ? quantities::porosity_of_coarse
                            : quantities::porosity_of_soil,
        list);
  judge(at + "grain_density", region.grain_density, quantities::grain_density, list);
  judge(at + "grain_bulk_modulus", region.grain_bulk_modulus, quantities::grain_modulus, list);
  // Darcy's law ends where water is no longer slow
  judge(at + "hydraulic_conductivity", k,
        region.flow == Flow::inertial ? quantities::conductivity : quantities::darcy_conductivity, list);
  // deposits in layers 0.1 to 1, varved clay down to 0.02; above 1 where cracks or drains stand upright
  judge(at + "conductivity_ratio", region.conductivity_ratio,
        {"1", 1e-3, 15., 0.02, 10., {{"percent", 1e-2}}, "layered soils have 0.02 to 1"}, list);
  judge(at + "permeability", region.permeability, quantities::permeability, list);
  // beta (1 - n)/(n^3 g d): of 1 m to 0.1 mm
  judge(at + "forchheimer", region.forchheimer,
        {"s2/m2", 1e-3, 1e6, 0.1, 3e4, {}, "stones of 1 m have 1 to 3, gravel of 1 cm 100 to 300"}, list);
  judge(at + "tortuosity", region.tortuosity, quantities::tortuosity, list);
}

/// Springs under a caisson of the weight W and the width B, at any scale. W over a spring is how far the caisson sinks
/// into it at rest: between a third of its width and less than on rock, 5e-6 of it. A rotation of less than W B/2 would
/// not keep it upright. Of strips on layers K_r/(K_x B^2) is 0.1 to 0.3 (Gazetas 1983).
void judge_springs(const std::string& at, const BaseSupport& springs, double W, double B, NumberedWarnings& list) {
  const Quantity spring{"Pa",
                        3. * W / B,
                        2e5 * W / B,
                        10. * W / B,
                        3e4 * W / B,
                        {{"kPa", 1e3}, {"MPa", 1e6}},
                        "so stiff that the caisson sinks by 3e-5 to 0.1 of its width"};
  const std::size_t before = list.size();
  judge(at + "horizontal", springs.horizontal, spring, list);
  const bool horizontal_fits = list.size() == before;
  judge(at + "vertical", springs.vertical, spring, list);
  const double usual = horizontal_fits ? springs.horizontal * B * B : 100. * W * B;
  judge(at + "rotation", springs.rotation,
        {"N",
         std::max(0.005 * usual, 0.5 * W * B),
         (horizontal_fits ? 10. : 1e3) * usual,
         std::max(0.05 * usual, W * B),
         (horizontal_fits ? 1. : 300.) * usual,
         {{"kN", 1e3}, {"MN", 1e6}},
         "0.1 to 0.3 times horizontal B^2"},
        list);
}

/// Dashpots by their share of critical damping c/(2 sqrt(k m)), at any scale: of footings on a half-space 0.3 to 0.6
/// in sliding, 0.5 to 1 in heave and 0.05 to 0.3 in rocking (Richart, Hall and Woods 1970). None at all is a choice.
void judge_dashpots(const std::string& at, const BaseSupport& dashpots, const BaseSupport& springs, const Body& body,
                    double bottom, NumberedWarnings& list) {
  const double about_base = body.moment_of_inertia + body.mass * std::pow(body.centre[1] - bottom, 2);
  const auto see = [&](const char* key, double c, double k, double m, const char* unit,
                       const std::vector<MeantUnit>& meant) {
    const double all = 2. * std::sqrt(k * m);  // critical
    if (c > 0. && all > 0.)
      judge(at + key, c, {unit, 1e-3 * all, 5. * all, 0.01 * all, 2. * all, meant, "0.05 to 1 of critical damping"},
            list);
  };
  const std::vector<MeantUnit> along{{"kN s/m2", 1e3}, {"MN s/m2", 1e6}}, about{{"kN s", 1e3}, {"MN s", 1e6}};
  see("horizontal", dashpots.horizontal, springs.horizontal, body.mass, "N s/m2", along);
  see("vertical", dashpots.vertical, springs.vertical, body.mass, "N s/m2", along);
  see("rotation", dashpots.rotation, springs.rotation, about_base, "N s", about);
}

/// Dashpots only where the springs fit.
void judge_support(const std::string& at, const Region& region, const Caisson& caisson, double gravity,
                   NumberedWarnings& list) {
  const std::size_t before = list.size();
  judge_springs(at + "springs.", *region.springs, caisson.body.mass * gravity, caisson.bottom_width, list);
  if (region.dashpots && list.size() == before)
    judge_dashpots(at + "dashpots.", *region.dashpots, *region.springs, caisson.body, caisson.bottom_centre[1], list);
}

NumberedWarnings plausibility_warnings(const Simulation& simulation, const std::optional<double>&) {
  NumberedWarnings list;
  const Scene& scene = simulation.given();
  const auto& caisson = simulation.compiled()->caisson;
  judge_fluid(scene, list);
  for (const auto& [name, region] : scene.regions) {
    const std::string at = "regions." + name + ".";
    const Quantity& modulus = name == caisson_name ? quantities::caisson_modulus : quantities::modulus;
    judge(at + "shear_modulus", region.shear_modulus, modulus, list);
    judge(at + "youngs_modulus", region.youngs_modulus, modulus, list);
    judge(at + "density", region.density, quantities::density, list);
    for (const auto& [part, values] : region.parts)
      judge(at + "parts." + part + ".density", values.density, quantities::density, list);
    judge_soil(at, region, scene, caisson ? caisson->bottom_width : 0., list);
    judge_pores(at, region, list);
    if (region.porosity && region.biot < *region.porosity)
      list.push_back({"biot_below_porosity", region.biot, *region.porosity, "1",
                      at + "biot = " + significant(region.biot) + " is less than the porosity, " +
                          significant(*region.porosity) +
                          ", which no grains that fill the skeleton alone can have: the pore pressure counts for less "
                          "than it is",
                      "give " + at + "biot of at least the porosity; 1 where grains are far stiffer than the soil"});
    if (region.springs && caisson) judge_support(at, region, *caisson, scene.gravity, list);
    if (region.interface)
      judge(at + "interface.coefficient", region.interface->coefficient, quantities::friction, list);
  }
  if (const int n = simulation.mesh()->n_divided_triangles; n > 0)
    list.push_back({"triangles_divided", static_cast<double>(n), 0., "1",
                    std::to_string(n) +
                        " triangles of the mesh were divided into three quadrilaterals each, and its "
                        "quadrilaterals into four: " +
                        std::to_string(simulation.mesh()->triangulation.n_active_cells()) +
                        " cells; quadrilaterals from the start need fewer unknowns",
                    "mesh by transfinite blocks with Recombine Surface, or Mesh.SubdivisionAlgorithm = 1"});
  constexpr double straight = 1e-6;
  if (const double bent = simulation.mesh()->most_bent; bent > straight)
    list.push_back({"sides_straightened", bent, straight, "1",
                    "cells of second order have curved sides, up to " + percent(bent) +
                        " of a side's length from its chord; they are read by their corners, with straight sides",
                    "use more cells along curved boundaries"});
  if (scene.sliding) judge("sliding.friction", scene.sliding->friction, quantities::friction, list);
  if (scene.initial)
    for (const auto& [name, surcharge] : scene.initial->surcharge)
      judge("initial.surcharge." + name + ".weight", surcharge.weight, quantities::surcharge, list);
  if (scene.cycles)  // a wave at least; of ten years of swell 3e7
    judge("cycles, all its waves,", std::accumulate(scene.cycles->number.begin(), scene.cycles->number.end(), 0.),
          {"1", 1., 1e8, 100., 1e5, {{"thousands", 1e3}}, "storms have 500 to 2e4"}, list);
  if (scene.sliding && simulation.compiled()->caisson)
    judge_weight("sliding.submerged_weight", scene.sliding->submerged_weight, simulation, list);
  return list;
}

}  // namespace

Finding plausibility_finding() {
  Finding f;
  f.of_scene = plausibility_warnings;
  return f;
}

}  // namespace upbead
