#include "fem/probes.h"

#include "fem/locate.h"
#include "point_rows.h"

namespace upbead {

using namespace dealii;

std::optional<Location> locate(const Space& space, const Point<dim>& point) {
  std::optional<Location> found;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (found && (space.has_pores(found->cell) || !space.has_pores(cell))) continue;
    if (const auto unit = unit_coordinates(cell, point)) found = Location{cell, *unit};
  }
  return found;
}

namespace {

void add_motion(std::vector<Reading>& list, const std::string& probe, const PointRows& rows) {
  const char* axis[] = {"x", "y"};
  const char* meaning[] = {"landward", "upward"};
  for (unsigned d = 0; d < dim; ++d) {
    const Row row = rows.value(d);
    list.push_back({{"probes", probe, std::string("displacement_") + axis[d]},
                    "m",
                    std::string("displacement, ") + meaning[d],
                    row,
                    {},
                    {},
                    {}});
    list.push_back({{"probes", probe, std::string("velocity_") + axis[d]},
                    "m/s",
                    std::string("velocity, ") + meaning[d],
                    {},
                    row,
                    {},
                    {}});
    list.push_back({{"probes", probe, std::string("acceleration_") + axis[d]},
                    "m/s2",
                    std::string("acceleration, ") + meaning[d],
                    {},
                    {},
                    row,
                    {}});
  }
}

/// Pore pressure p = phi'; where the fluid has inertia, Darcy velocity w = W'.
void add_pore_water(std::vector<Reading>& list, const std::string& probe, const PointRows& rows, CellKind kind) {
  list.push_back({{"probes", probe, "pressure"}, "Pa", "excess pore pressure", {}, rows.value(phi_component), {}, {}});
  if (kind != CellKind::inertial) return;
  list.push_back(
      {{"probes", probe, "darcy_velocity_x"}, "m/s", "relative fluid velocity, landward", {}, rows.value(dim), {}, {}});
  list.push_back({{"probes", probe, "darcy_velocity_y"},
                  "m/s",
                  "relative fluid velocity, upward",
                  {},
                  rows.value(dim + 1),
                  {},
                  {}});
}

/// Pressure of free water, and its velocity -grad phi / rho_f.
void add_water(std::vector<Reading>& list, const std::string& probe, const PointRows& rows, double density) {
  list.push_back(
      {{"probes", probe, "pressure"}, "Pa", "change of the water's pressure", {}, rows.value(phi_component), {}, {}});
  const char* axis[] = {"x", "y"};
  const char* meaning[] = {"landward", "upward"};
  for (unsigned d = 0; d < dim; ++d)
    list.push_back({{"probes", probe, std::string("velocity_") + axis[d]},
                    "m/s",
                    std::string("velocity of the water, ") + meaning[d],
                    rows.phi_gradient(d, -1. / density),
                    {},
                    {},
                    {}});
}

void add_strain_and_stress(std::vector<Reading>& list, const std::string& probe, const PointRows& rows,
                           const Region& region, const ElasticLaw& law) {
  const std::string stress = region.kind == RegionKind::porous ? "effective_stress" : "stress";
  const std::string text = region.kind == RegionKind::porous ? "effective stress " : "stress ";
  const struct {
    const char* name;
    double PlaneStrain::*strain;
    double PlaneStress::*stress;
  } components[] = {{"xx", &PlaneStrain::xx, &PlaneStress::xx},
                    {"yy", &PlaneStrain::yy, &PlaneStress::yy},
                    {"xy", &PlaneStrain::xy, &PlaneStress::xy},
                    {"zz", nullptr, &PlaneStress::zz}};
  for (const auto& c : components) {
    if (c.strain)
      list.push_back({{"probes", probe, std::string("strain_") + c.name},
                      "1",
                      std::string("strain ") + c.name + ", extension positive",
                      rows.strain(c.strain),
                      {},
                      {},
                      {}});
    list.push_back({{"probes", probe, stress + "_" + c.name},
                    "Pa",
                    text + c.name + ", tension positive",
                    rows.stress(law, c.stress),
                    {},
                    {},
                    {}});
  }
}

}  // namespace

std::vector<Reading> probe_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                    const std::string& name) {
  const Probe& probe = scene.probes.at(name);
  const Location location = *locate(space, Point<dim>(probe.at[0], probe.at[1]));
  const Region& region = space.region(location.cell);
  const PointRows rows(space, unknowns, location);
  std::vector<Reading> list;
  if (region.kind == RegionKind::water) {
    add_water(list, name, rows, scene.fluid.density);
    return list;
  }
  add_motion(list, name, rows);
  if (space.has_pressure(location.cell)) add_pore_water(list, name, rows, space.kind(location.cell));
  if (region.kind != RegionKind::rigid) add_strain_and_stress(list, name, rows, region, space.material(location.cell));
  return list;
}

}  // namespace upbead
