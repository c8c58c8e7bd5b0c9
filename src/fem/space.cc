#include "fem/space.h"

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

namespace upbead {

using namespace dealii;

namespace {

hp::FECollection<dim> make_elements(unsigned k) {
  const FE_Q<dim> u(k), phi(k - 1);
  const FE_DGQ<dim> W(k - 1);
  const FE_Nothing<dim> none;
  hp::FECollection<dim> elements;  // in the order of CellKind
  elements.push_back(FESystem<dim>(u, dim, none, dim, none, 1));
  elements.push_back(FESystem<dim>(u, dim, none, dim, phi, 1));
  elements.push_back(FESystem<dim>(u, dim, W, dim, phi, 1));
  elements.push_back(FESystem<dim>(none, dim, none, dim, u, 1));  // phi of degree k, which the added mass needs
  elements.push_back(FESystem<dim>(none, dim, none, dim, none, 1));
  return elements;
}

/// A copy of the region with the soil's stiffness, damping, pore fluid and conductivity in one of its cells.
Region in_cell(Region region, const SoilState& soil, std::size_t cell) {
  if (!soil.shear_modulus.empty() && soil.shear_modulus[cell] > 0.) region.shear_modulus = soil.shear_modulus[cell];
  if (!soil.damping_ratio.empty() && region.damping && soil.damping_ratio[cell] >= 0.)
    region.damping->ratio = soil.damping_ratio[cell];
  if (!soil.pore_fluid.empty() && soil.pore_fluid[cell] > 0.) region.pore_fluid_modulus = soil.pore_fluid[cell];
  if (!soil.conductivity.empty() && soil.conductivity[cell] > 0.)
    region.hydraulic_conductivity = soil.conductivity[cell];
  return region;
}

}  // namespace

Space::Space(const Mesh& mesh, const Scene& scene, const std::vector<bool>& absent, const SoilState& soil)
    : mesh_(&mesh), degree_(scene.mesh.degree), by_cell_(soil.varies()) {
  const auto constants = [&scene](const Region& r) { return upbead::material(r, scene.fluid, scene.gravity); };
  for (const std::string& name : mesh.surfaces) regions_.push_back(scene.regions.at(name));
  if (by_cell_)
    for (const auto& cell : mesh.triangulation.active_cell_iterators())
      materials_.push_back(constants(in_cell(region(cell), soil, cell->active_cell_index())));
  else
    for (const Region& region : regions_) materials_.push_back(constants(region));
  const auto dofs = std::make_shared<DoFHandler<dim>>(mesh.triangulation);
  for (const auto& cell : dofs->active_cell_iterators())
    cell->set_active_fe_index(static_cast<unsigned>(
        !absent.empty() && absent[cell->active_cell_index()] ? CellKind::absent : kind_of(region(cell))));
  dofs->distribute_dofs(make_elements(static_cast<unsigned>(scene.mesh.degree)));
  dofs_ = dofs;
}

Space Space::with(const std::vector<RegionConstants>& constants) const {
  Space other = *this;
  other.by_cell_ = false;
  other.constants_ = constants;
  other.materials_.clear();
  for (const RegionConstants& of_region : constants) other.materials_.push_back(of_region.material);
  return other;
}

Space Space::with(const Scene& scene) const {
  Space other = *this;
  other.by_cell_ = false;
  other.regions_.clear();
  other.materials_.clear();
  for (const std::string& name : mesh_->surfaces) {
    other.regions_.push_back(scene.regions.at(name));
    other.materials_.push_back(upbead::material(other.regions_.back(), scene.fluid, scene.gravity));
  }
  return other;
}

Impedance Space::impedance(const Cell& cell, bool open) const {
  if (constants_.empty()) return upbead::impedance(material(cell), kind(cell), open);
  const RegionConstants& constants = constants_[cell->material_id()];
  return open ? constants.open : constants.sealed;
}

Dofs dofs_of(const Cell& cell) {
  Dofs dofs(cell->get_fe().n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  return dofs;
}

DofNode node_of(const Space& space, const Cell& cell, unsigned i) {
  const auto& fe = cell->get_fe();
  const auto [component, node] = fe.system_to_component_index(i);
  const auto& base = fe.base_element(fe.component_to_base_index(component).first);
  return {component, space.mapping().transform_unit_to_real_cell(cell, base.unit_support_point(node))};
}

}  // namespace upbead
