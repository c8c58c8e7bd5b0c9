// The end of a case that leaves it to its loads: when these and the answer of the section to them are over.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/time_end.h"
#include "fem/caisson/wall_water.h"
#include "mesh/extent.h"

namespace upbead {

namespace {

constexpr double periods_of_echo = 3.;  ///< radiation damps a caisson on sand by a quarter or so: 1 % is left

/// The part of a mesh that some cells fill, and means over its area.
struct Part : Extent {
  double slowness = 0., compliance = 0., poisson = 0.;  ///< sums of area times 1/V_s, 1/G, nu
  double mass = 0.;                                     ///< kg/m
};

bool deforms(const Region& region) {
  return region.kind == RegionKind::porous || region.kind == RegionKind::solid;
}

/// G (Pa), of the law of stress that at its reference.
double shear_modulus(const Region& region) {
  if (region.stress_law) return region.stress_law->reference;
  return region.shear_modulus ? *region.shear_modulus : *region.youngs_modulus / (2. * (1. + *region.poissons_ratio));
}

/// The end, and why, for people, with the numbers.
struct SettledEnd {
  double seconds = 0.;
  std::string why;
};

struct Parts {
  Part ground, caisson;
  double consolidation = 0.;  ///< of the slowest region, H^2/c_v (s)
  std::optional<BaseSupport> springs;
  WallMass water;  ///< beside the caisson's walls
};

Parts parts_of(const Scene& scene, const Mesh& mesh) {
  Parts parts;
  std::map<std::string, Part> regions;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) regions[mesh.surface_of(cell)].add(cell);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& name = mesh.surface_of(cell);
    const auto found = scene.regions.find(name);
    if (found == scene.regions.end()) continue;  // the checks of the scene will tell
    const Region& region = found->second;
    if (name == caisson_name) {
      parts.springs = region.springs;
      parts.caisson.add(cell);
      parts.caisson.mass = region.mass_over(regions[name].area);
      parts.water = beside_walls(region.added_mass.value_or(WallWater()), scene.fluid.density);
    } else if (deforms(region)) {
      const double G = shear_modulus(region), area = area_of(cell);
      parts.ground.add(cell);
      parts.ground.slowness += area * std::sqrt(material(region, scene.fluid, scene.gravity).rho / G);
      parts.ground.compliance += area / G;
      parts.ground.poisson += area * region.poissons_ratio.value_or(0.3);
    }
  }
  for (const auto& [name, region] : scene.regions) {
    const auto k = conductivity(region, scene.fluid, scene.gravity);
    if (region.kind != RegionKind::porous || !k || region.flow == Flow::drained || regions.count(name) == 0) continue;
    const Part& part = regions[name];
    const double nu = *region.poissons_ratio, M = shear_modulus(region) * 2. * (1. - nu) / (1. - 2. * nu);
    const double c_v = region.conductivity_ratio * *k * M / (scene.fluid.density * scene.gravity);
    parts.consolidation = std::max(parts.consolidation, part.height() * part.height() / c_v);
  }
  return parts;
}

/// Of a caisson in sway and rocking with the water beside it by Dunkerley's rule, J about its base (s).
double period_on(const BaseSupport& springs, const Part& caisson, const WallMass& water) {
  const double h = caisson.height(), b = 0.5 * caisson.width();
  const double J = caisson.mass * (h * h / 3. + b * b / 3.) + water.second;
  return 2. * pi * std::sqrt((caisson.mass + water.mass) / springs.horizontal + J / springs.rotation);
}

/// The period of the caisson (s) by Dunkerley's rule for sway and rocking on the springs of a strip of half width b on
/// a layer of depth H, K_x = 2.1 G/(2 - nu) (1 + 2b/H), K_r = pi G b^2/(2 (1 - nu)) (1 + b/(5H)) (Gazetas, Soil Dyn.
/// Earthq. Eng. 2 (1983) 2); 0 without a caisson or what bears it.
double period_of_caisson(const Parts& parts) {
  const Part &ground = parts.ground, &caisson = parts.caisson;
  if (!(caisson.mass > 0.)) return 0.;
  if (parts.springs) return period_on(*parts.springs, caisson, parts.water);
  if (!(ground.area > 0.)) return 0.;
  const double H = ground.height();
  const double G = ground.area / ground.compliance, nu = ground.poisson / ground.area, b = 0.5 * caisson.width();
  const double K_x = 2.1 * G / (2. - nu) * (1. + 2. * b / H);
  const double K_r = pi * G * b * b / (2. * (1. - nu)) * (1. + b / (5. * H));
  return period_on({K_x, 0., K_r}, caisson, parts.water);
}

/// The longest period in which the section swings (s): of the ground as a layer in shear, 4 H/V_s, or of the caisson on
/// it.
double period_of(const Parts& parts) {
  const Part& ground = parts.ground;
  const double shear = parts.springs || !(ground.area > 0.) ? 0. : 4. * ground.height() * ground.slowness / ground.area;
  return std::max(shear, period_of_caisson(parts));
}

/// Two digits, not less than the value.
double rounded_up(double value) {
  const double unit = std::pow(10., std::floor(std::log10(value)) - 1.);
  return std::ceil(value / unit * (1. - 1e-9)) * unit;
}

SettledEnd settled_end(const Case& input, const Mesh& mesh) {
  const double loads = end_of_actions(input);
  const bool inertia = input.scene.time.inertia;
  const Parts parts = parts_of(input.scene, mesh);
  const double echo = inertia ? periods_of_echo * period_of(parts) : parts.consolidation;
  SettledEnd end;
  const double wanted = loads + echo > 0. ? rounded_up(loads + echo) : TimeChoice().end;
  const double last_output = input.scene.output_times.empty() ? 0. : input.scene.output_times.back();
  end.seconds = std::max({wanted, last_output, input.scene.time.step.value_or(0.)});
  end.why = "as time.end is not given: the loads are over at " + significant(loads, 4) + " s, " +
            (inertia ? "three times the section's own period" : "H^2/c_v, in which the pore pressure leaves") + " is " +
            significant(echo, 3) + " s";
  if (last_output > wanted) end.why += ", and [output] times goes on until then";
  return end;
}

}  // namespace

double swing_period(const Scene& scene, const Mesh& mesh) {
  return period_of_caisson(parts_of(scene, mesh));
}

double end_on(const Case& input, const Mesh& mesh) {
  const bool is_known = !end_is_open(input) || !input.why_end.empty();
  return is_known ? input.scene.time.end : settled_end(input, mesh).seconds;
}

std::shared_ptr<const Mesh> settle_end(Case& input) {
  if (!end_is_open(input)) return nullptr;
  return in_places_of(input, [&] {
    std::shared_ptr<const Mesh> mesh = read_mesh(mesh_request(input));
    SettledEnd end = settled_end(input, *mesh);
    input.scene.time.end = end.seconds;
    input.why_end = std::move(end.why);
    return mesh;
  });
}

}  // namespace upbead
