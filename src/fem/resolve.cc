#include "upbead/fem/resolve.h"

#include <cmath>
#include <limits>

#include "base/text.h"
#include "fem/curve_course.h"
#include "fem/domain_of_influence.h"
#include "fem/outline.h"
#include "fem/static_stage.h"
#include "fem/volume_loads.h"
#include "model/choices.h"
#include "model/words.h"

namespace upbead {

using namespace dealii;

namespace {

bool has_probe_in(const Scene& scene, const Mesh& mesh, const std::string& region) {
  for (const auto& [name, probe] : scene.probes)
    for (const auto& cell : mesh.triangulation.active_cell_iterators())
      if (mesh.surface_of(cell) == region && unit_coordinates(cell, Point<dim>(probe.at[0], probe.at[1]))) return true;
  return false;
}

/// Whether a load maintains the pore pressure in its region.
bool acts_on_pores(const Load& load) {
  return load.kind == LoadKind::gravity || load.kind == LoadKind::source;
}

Surroundings surroundings_of(const std::string& name, const Scene& scene, const Mesh& mesh, const Outline& outline) {
  const Bounds& bounds = outline.surfaces.at(name);
  Surroundings at;
  at.height = bounds.highest - bounds.lowest;
  at.width = bounds.right - bounds.left;
  at.has_probe = scene.fields_every.has_value() || has_probe_in(scene, mesh, name);
  for (const std::string& other : outline.touching(name)) {
    at.touches.push_back(other);
    at.touches_water = at.touches_water || scene.regions.at(other).kind == RegionKind::water;
  }
  for (const auto& [curve, outer] : outline.outer) {
    if (!outer.surfaces.count(name)) continue;
    const Boundary& side = scene.boundaries.at(curve);
    at.has_open_side = at.has_open_side || side.pressure == PressureCondition::open ||
                       side.pressure == PressureCondition::surface_waves;
    at.is_held = at.is_held || side.displacement != DisplacementCondition::free;
    for (const auto& [load_name, load] : scene.loads)
      at.has_load = at.has_load || (load.kind == LoadKind::pressure && load.boundary == curve && load.factor != 0.);
  }
  for (const auto& [load_name, load] : scene.loads)
    at.has_load = at.has_load || (load.factor != 0. && acts_on_pores(load) && acts_on(load, name));
  return at;
}

Decision decide_flow(const std::string& name, Region& region, const Surroundings& at, const Scene& scene) {
  const FlowChoice choice = choose_flow(region, at, scene);
  region.flow = choice.flow;
  std::string left_out;
  if (choice.flow == Flow::darcy) left_out = "relative inertia of the pore water in " + name;
  if (choice.flow == Flow::drained) left_out = "pore pressure in " + name;
  return {name, "flow", word_of(choice.flow, flow_words), choice.reason, left_out};
}

Decision decide_deformation(const std::string& name, Region& region, const Surroundings& at, const Scene& scene) {
  const DeformationChoice choice = choose_deformation(region, at, scene);
  region.deformation = choice.deformation;
  const bool rigid = choice.deformation == Deformation::rigid;
  if (rigid) {
    region.kind = RegionKind::rigid;
    region.damping.reset();
  }
  return {name, "deformation", word_of(choice.deformation, deformation_words), choice.reason,
          rigid ? "deformation of " + name : ""};
}

Decision decide_compressibility(const std::string& name, Region& region, const Surroundings& at, const Scene& scene) {
  const CompressibilityChoice choice = choose_compressibility(region, at, scene);
  region.compressibility = choice.compressibility;
  const bool incompressible = choice.compressibility == Compressibility::incompressible;
  return {name, "compressibility", word_of(choice.compressibility, compressibility_words), choice.reason,
          incompressible ? "compression of the water in " + name : ""};
}

/// Absolute pressure of still water of that level at the height y.
double absolute_pressure(const Scene& scene, double level, double y) {
  return scene.fluid.atmospheric_pressure + scene.fluid.density * scene.gravity * std::max(0., level - y);
}

/// Finds k from the intrinsic permeability, and the modulus of pore water that contains air, at the pressure of still
/// water at the middle of the region's height.
void find_pore_fluid(const std::string& name, Region& region, const Bounds& bounds, double level,
                     ResolvedScene& resolved) {
  const Fluid& fluid = resolved.scene.fluid;
  if (region.permeability) {
    region.hydraulic_conductivity = conductivity(region, fluid, resolved.scene.gravity);
    region.permeability.reset();
    resolved.decisions.push_back({name, "hydraulic_conductivity", significant(*region.hydraulic_conductivity) + " m/s",
                                  "kappa rho_f g / mu of permeability and fluid.viscosity", ""});
  }
  if (region.saturation == 1.) return;
  const double middle = 0.5 * (bounds.lowest + bounds.highest), p = absolute_pressure(resolved.scene, level, middle);
  region.pore_fluid_modulus = pore_fluid_modulus(fluid, region.saturation, p);
  resolved.decisions.push_back({name, "saturation", with_unit(*region.pore_fluid_modulus, "Pa") + " for K_f",
                                significant(100. * (1. - region.saturation)) + " % of the pores are air at " +
                                    with_unit(p, "Pa") + " absolute, " + significant(std::max(0., level - middle)) +
                                    " m below still water" +
                                    (region.air_by_depth ? ", and likewise in each cell at its own depth" : ""),
                                ""});
}

/// The modulus of pore water with air in each cell at the pressure of still water there, where a region asks for that.
void find_air(const Mesh& mesh, double level, ResolvedScene& resolved) {
  const Scene& scene = resolved.scene;
  std::vector<double>& modulus = resolved.soil.pore_fluid;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const Region& region = scene.regions.at(mesh.surface_of(cell));
    if (!region.air_by_depth) continue;
    if (!std::isfinite(level))
      throw InputError(at_key("regions." + mesh.surface_of(cell) + ".air_by_depth"),
                       "the level of still water is not known, so that no cell has a depth",
                       "give [initial] water_level");
    modulus.resize(mesh.triangulation.n_active_cells(), 0.);
    modulus[cell->active_cell_index()] =
        pore_fluid_modulus(scene.fluid, region.saturation, absolute_pressure(scene, level, cell->center()[1]));
  }
}

/// Least and largest value of a quantity over one region's cells.
struct Spread {
  double least = std::numeric_limits<double>::infinity(), largest = 0.;
  void add(double value) { least = std::min(least, value), largest = std::max(largest, value); }
  std::string text(double unit) const { return significant(least / unit) + " to " + significant(largest / unit); }
};

/// Finds G of every cell from its static stress; the largest value stands for the region where only one is needed.
void find_stiffness(const Mesh& mesh, ResolvedScene& resolved) {
  const StaticStage stage = solve_static(resolved.scene, mesh);
  resolved.soil.shear_modulus = stage.shear_modulus;
  for (auto& [name, region] : resolved.scene.regions) {
    if (!region.stress_law) continue;
    Spread G, p;
    for (const auto& cell : mesh.triangulation.active_cell_iterators())
      if (mesh.surface_of(cell) == name) {
        G.add(stage.shear_modulus[cell->active_cell_index()]);
        p.add(stage.stress.mean(cell->active_cell_index(), k0_to_apply(resolved.scene)));
      }
    region.shear_modulus = G.largest;
    resolved.decisions.push_back(
        {name, "shear_modulus", G.text(1e6) + " MPa", "mean effective stress " + p.text(1e3) + " kPa at rest", ""});
  }
}

/// Leaves out water that touches no other region: it cannot move anything.
void leave_out_idle_water(const Outline& outline, const Mesh& mesh, ResolvedScene& resolved) {
  for (const auto& [name, region] : resolved.scene.regions) {
    if (region.kind != RegionKind::water || !outline.touching(name).empty()) continue;
    if (resolved.scene.fields_every || has_probe_in(resolved.scene, mesh, name)) continue;
    resolved.decisions.push_back({name, "kind", "absent", "none of its sides is wet: it touches nothing", name});
    resolved.absent.resize(mesh.triangulation.n_active_cells(), false);
    for (const auto& cell : mesh.triangulation.active_cell_iterators())
      if (mesh.surface_of(cell) == name) resolved.absent[cell->active_cell_index()] = true;
  }
}

void leave_out_unreached(const Mesh& mesh, ResolvedScene& resolved) {
  const DomainOfInfluence domain = domain_of_influence(resolved.scene, mesh);
  if (domain.n_outside == 0) return;
  resolved.absent.resize(domain.outside.size(), false);
  for (std::size_t i = 0; i < domain.outside.size(); ++i) resolved.absent[i] = resolved.absent[i] || domain.outside[i];
  const std::string cells = std::to_string(domain.n_outside) + " cells";
  resolved.decisions.push_back({"", "full_domain", "false",
                                "waves of at most " + significant(domain.speed) +
                                    " m/s do not come there and back within " + significant(resolved.scene.time.end) +
                                    " s",
                                cells});
}

void tell_construction(ResolvedScene& resolved) {
  if (resolved.scene.construction.empty()) return;
  std::string stages;
  for (const std::string& name : stages_in_order(resolved.scene)) stages += (stages.empty() ? "" : ", then ") + name;
  resolved.decisions.push_back({"", "construction", stages,
                                "stresses at rest come of these stages, each drained; settlement by them is not that "
                                "of the waves",
                                "pore pressure of construction and its consolidation over time"});
}

Decision tell_densification(const std::string& name, const Densification& law) {
  return {name, "densification", "C1 = " + significant(law.C1()) + ", C2 = " + significant(law.C2()),
          "cycles of shear pack it denser (Byrne 1991); its strength at rest stays unless law = \"mohr_coulomb\"", ""};
}

/// By which curve cycles of a storm liquefy a soil, and what of it is assumed.
Decision tell_cyclic(const std::string& name, const CyclicSoil& soil) {
  const bool given = soil.alpha && soil.beta;
  return {name, "cyclic", "tau/sigma'_0 = " + significant(soil.alpha_r()) + " N^" + significant(soil.beta_r()),
          std::string("N cycles liquefy it; ") +
              (given ? "as the case says"
                     : "assumed, by D_r: alpha = 0.34 D_r + 0.084, beta = 0.37 D_r - 0.46 (Sumer and others 2012)"),
          ""};
}

}  // namespace

Decision tell_damping(const std::string& name, const Rayleigh& damping) {
  const double middle = std::sqrt(damping.frequencies[0] * damping.frequencies[1]);
  return {name, "damping", significant(100. * damping.ratio) + " %",
          "by Rayleigh " + significant(100. * damping.ratio_at(damping.frequencies[0])) + " % at " +
              significant(damping.frequencies[0]) + " and " + significant(damping.frequencies[1]) + " Hz, " +
              significant(100. * damping.ratio_at(middle)) + " % at " + significant(middle) + " Hz: within " +
              significant(100. * damping.error(), 2) + " % of it",
          ""};
}

namespace {

Decision tell_springs(const std::string& name, const BaseSupport& springs) {
  return {name, "springs",
          with_unit(springs.horizontal, "Pa") + ", " + with_unit(springs.vertical, "Pa") + ", " +
              with_unit(springs.rotation, "N"),
          "horizontal, vertical and rotation at the middle of the base, as the case says, in place of ground",
          "the ground, its waves and its pore pressure"};
}

/// How the stress of a region follows its strain, and its damping.
void tell_laws(const std::string& name, const Region& region, ResolvedScene& resolved) {
  if (region.springs) resolved.decisions.push_back(tell_springs(name, *region.springs));
  if (region.law != SoilLaw::elastic)
    resolved.decisions.push_back({name, "law", word_of(region.law, soil_law_words),
                                  "as the case says; where it yields nothing is linear, so it is marched", ""});
  if (region.forchheimer)
    resolved.decisions.push_back({name, "drag", "drag made linear",
                                  "at the velocity that the pore water has while all soil is elastic and the caisson "
                                  "is bonded, settled when it is run",
                                  ""});
  if (region.densification) resolved.decisions.push_back(tell_densification(name, *region.densification));
  if (region.cyclic && resolved.scene.cycles) resolved.decisions.push_back(tell_cyclic(name, *region.cyclic));
  if (region.strain_law && region.law == SoilLaw::elastic)
    resolved.decisions.push_back({name, "strain", "equivalent-linear",
                                  "stiffness and damping follow the shear strain, settled when it is run", ""});
  if (region.damping && !(region.strain_law && region.law == SoilLaw::elastic))
    resolved.decisions.push_back(tell_damping(name, *region.damping));
}

}  // namespace

ResolvedScene resolve(const Scene& scene, const Mesh& mesh) {
  const Outline outline = outline_of(mesh);
  ResolvedScene resolved{scene, {}, {}, {}};
  follow_curves(mesh, resolved.scene);
  for (const auto& [name, region] : scene.regions)
    if (!outline.surfaces.count(name)) {
      resolved.scene.regions.erase(name);
      resolved.decisions.push_back({name, "kind", "absent", "the mesh has no such surface", name});
    }
  if (needs_static_stage(resolved.scene)) find_stiffness(mesh, resolved);
  const double level = water_level(scene, mesh);
  for (auto& [name, region] : resolved.scene.regions)
    if (region.kind == RegionKind::porous) find_pore_fluid(name, region, outline.surfaces.at(name), level, resolved);
  find_air(mesh, level, resolved);
  for (auto& [name, region] : resolved.scene.regions) {
    const Surroundings at = surroundings_of(name, scene, mesh, outline);
    switch (region.kind) {
      case RegionKind::porous:
        resolved.decisions.push_back(decide_flow(name, region, at, scene));
        break;
      case RegionKind::solid:
        resolved.decisions.push_back(decide_deformation(name, region, at, scene));
        break;
      case RegionKind::water:
        resolved.decisions.push_back(decide_compressibility(name, region, at, scene));
        break;
      case RegionKind::rigid:
        resolved.decisions.push_back(
            {name, "deformation", "rigid", "three coordinates stand for it", "deformation of " + name});
        break;
    }
  }
  for (const auto& [name, region] : resolved.scene.regions) tell_laws(name, region, resolved);
  tell_construction(resolved);
  leave_out_idle_water(outline, mesh, resolved);
  leave_out_unreached(mesh, resolved);
  return resolved;
}

}  // namespace upbead
