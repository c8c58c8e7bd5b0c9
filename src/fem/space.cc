#include "upbead/fem/space.h"

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

namespace upbead {

using namespace dealii;

namespace {

CellKind kind_of(const Region& region) {
  if (region.kind != RegionKind::porous || region.flow == Flow::drained) return CellKind::solid;
  return region.flow == Flow::inertial ? CellKind::inertial : CellKind::darcy;
}

hp::FECollection<dim> make_elements(unsigned k) {
  const FE_Q<dim> u(k), phi(k - 1);
  const FE_DGQ<dim> W(k - 1);
  const FE_Nothing<dim> none;
  hp::FECollection<dim> elements;  // in the order of CellKind
  elements.push_back(FESystem<dim>(u, dim, none, dim, none, 1));
  elements.push_back(FESystem<dim>(u, dim, none, dim, phi, 1));
  elements.push_back(FESystem<dim>(u, dim, W, dim, phi, 1));
  return elements;
}

}  // namespace

Space::Space(const Mesh& mesh, const Scene& scene, const std::map<std::string, FlowChoice>& flows)
    : mesh_(&mesh),
      degree_(scene.mesh.degree),
      elements_(make_elements(static_cast<unsigned>(scene.mesh.degree))),
      dofs_(mesh.triangulation) {
  for (const std::string& name : mesh.surfaces) {
    Region region = scene.regions.at(name);
    if (const auto choice = flows.find(name); choice != flows.end()) region.flow = choice->second.flow;
    regions_.push_back(region);
  }
  for (const auto& cell : dofs_.active_cell_iterators())
    cell->set_active_fe_index(static_cast<unsigned>(kind_of(region(cell))));
  dofs_.distribute_dofs(elements_);
}

const Region& Space::region(const DoFHandler<dim>::active_cell_iterator& cell) const {
  return regions_[cell->material_id()];
}

bool Space::has_pressure(const DoFHandler<dim>::active_cell_iterator& cell) const {
  return cell->active_fe_index() != static_cast<unsigned>(CellKind::solid);
}

}  // namespace upbead
