#include "fem/probes.h"

#include <deal.II/fe/fe_values.h>

#include <map>
#include <optional>

#include "fem/kernels.h"
#include "fem/outline.h"

namespace upbead {

using namespace dealii;

namespace {

/// A point of the mesh: its cell, and its coordinates in the unit cell.
struct Location {
  Cell cell;
  Point<dim> unit;
};

/// The cell that holds a point; if there are several, one with pore water. None outside the mesh.
std::optional<Location> locate(const Space& space, const Point<dim>& point) {
  std::optional<Location> found;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (found && (space.has_pores(found->cell) || !space.has_pores(cell))) continue;
    if (const auto unit = unit_coordinates(cell, point)) found = Location{cell, *unit};
  }
  return found;
}

/// Rows of point values at one location.
class PointRows {
 public:
  PointRows(const Space& space, const Unknowns& unknowns, const Location& location)
      : unknowns_(unknowns),
        values_(space.mapping(), location.cell->get_fe(), Quadrature<dim>(location.unit),
                update_values | update_gradients),
        dofs_(dofs_of(location.cell)) {
    values_.reinit(typename Triangulation<dim>::cell_iterator(location.cell));
  }

  Row value(unsigned component) const {
    return row([&](unsigned i) { return values_.shape_value_component(i, 0, component); });
  }
  /// `factor` times a component of grad phi.
  Row phi_gradient(unsigned d, double factor) const {
    return row([&](unsigned i) { return factor * values_[phi_part].gradient(i, 0)[d]; });
  }
  Row strain(double PlaneStrain::*component) const {
    return row([&](unsigned i) { return strain_of(values_, i, 0).*component; });
  }
  Row stress(const ElasticLaw& law, double PlaneStress::*component) const {
    return row([&](unsigned i) { return law.stress(strain_of(values_, i, 0)).*component; });
  }

 private:
  template <typename Value>
  Row row(const Value& value) const {
    std::map<int, double> entries;
    for (unsigned i = 0; i < dofs_.size(); ++i)
      if (const double v = value(i); v != 0.) unknowns_.add_to(entries, dofs_[i], v);
    return to_row(entries);
  }

  const Unknowns& unknowns_;
  FEValues<dim> values_;
  Dofs dofs_;
};

void add_motion(std::vector<Reading>& list, const std::string& probe, const PointRows& rows) {
  const char* axis[] = {"x", "y"};
  const char* meaning[] = {"landward", "upward"};
  for (unsigned d = 0; d < dim; ++d) {
    const Row row = rows.value(d);
    list.push_back(position_reading({"probes", probe, std::string("displacement_") + axis[d]}, "m",
                                    std::string("displacement, ") + meaning[d], row));
    list.push_back(velocity_reading({"probes", probe, std::string("velocity_") + axis[d]}, "m/s",
                                    std::string("velocity, ") + meaning[d], row));
    list.push_back(acceleration_reading({"probes", probe, std::string("acceleration_") + axis[d]}, "m/s2",
                                        std::string("acceleration, ") + meaning[d], row));
  }
}

/// Pore pressure p = phi'; with inertial flow also the Darcy velocity w = W'.
void add_pore_water(std::vector<Reading>& list, const std::string& probe, const PointRows& rows, CellKind kind) {
  list.push_back(
      velocity_reading({"probes", probe, "pressure"}, "Pa", "excess pore pressure", rows.value(phi_component)));
  if (kind != CellKind::inertial) return;
  list.push_back(velocity_reading({"probes", probe, "darcy_velocity_x"}, "m/s", "relative fluid velocity, landward",
                                  rows.value(dim)));
  list.push_back(velocity_reading({"probes", probe, "darcy_velocity_y"}, "m/s", "relative fluid velocity, upward",
                                  rows.value(dim + 1)));
}

/// Pressure of free water, and its velocity u' = -grad phi / rho_f.
void add_water(std::vector<Reading>& list, const std::string& probe, const PointRows& rows, double density) {
  list.push_back(velocity_reading({"probes", probe, "pressure"}, "Pa", "change of the water's pressure",
                                  rows.value(phi_component)));
  const char* axis[] = {"x", "y"};
  const char* meaning[] = {"landward", "upward"};
  for (unsigned d = 0; d < dim; ++d)
    list.push_back(position_reading({"probes", probe, std::string("velocity_") + axis[d]}, "m/s",
                                    std::string("velocity of the water, ") + meaning[d],
                                    rows.phi_gradient(d, -1. / density)));
}

struct StressComponent {
  const char* name;
  double PlaneStrain::*strain;
  double PlaneStress::*stress;
};
constexpr StressComponent components[] = {{"xx", &PlaneStrain::xx, &PlaneStress::xx},
                                          {"yy", &PlaneStrain::yy, &PlaneStress::yy},
                                          {"xy", &PlaneStrain::xy, &PlaneStress::xy},
                                          {"zz", nullptr, &PlaneStress::zz}};

std::string stress_name(const Region& region) {
  return region.kind == RegionKind::porous ? "effective_stress" : "stress";
}

void add_strain_and_stress(std::vector<Reading>& list, const std::string& probe, const PointRows& rows,
                           const Region& region, const ElasticLaw& law) {
  const std::string stress = stress_name(region);
  const std::string text = region.kind == RegionKind::porous ? "effective stress " : "stress ";
  for (const StressComponent& c : components) {
    if (c.strain)
      list.push_back(position_reading({"probes", probe, std::string("strain_") + c.name}, "1",
                                      std::string("strain ") + c.name + ", extension positive", rows.strain(c.strain)));
    list.push_back(position_reading({"probes", probe, stress + "_" + c.name}, "Pa",
                                    text + c.name + ", tension positive", rows.stress(law, c.stress)));
  }
}

}  // namespace

std::map<int, double> pressure_row(const Unknowns& unknowns, const Cell& cell, const Point<dim>& unit) {
  std::map<int, double> row;
  const FiniteElement<dim>& fe = cell->get_fe();
  const Dofs dofs = dofs_of(cell);
  for (unsigned i = 0; i < dofs.size(); ++i)
    if (fe.system_to_component_index(i).first == phi_component)
      unknowns.add_to(row, dofs[i], fe.shape_value_component(i, unit, phi_component));
  return row;
}

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

std::vector<FollowedReading> followed_readings(const Space& space, const Scene& scene) {
  std::vector<FollowedReading> list;
  for (const auto& [name, probe] : scene.probes) {
    const Location location = *locate(space, Point<dim>(probe.at[0], probe.at[1]));
    const Region& region = space.region(location.cell);
    if (region.law == SoilLaw::elastic) continue;
    FollowedReading at{location.cell, location.unit, {}};
    for (const StressComponent& c : components)
      at.components.emplace_back(ReadingName("probes", name, stress_name(region) + "_" + c.name), c.stress);
    list.push_back(std::move(at));
  }
  return list;
}

}  // namespace upbead
