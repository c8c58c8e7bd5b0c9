#include "fem/volume_loads.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "fem/sides.h"

namespace upbead {

using namespace dealii;

namespace {

/// Work of a load at one point in a unit of the degree of freedom i.
class Density {
 public:
  Density(const Load& load, const Space& space, const Cell& cell)
      : load_(load), material_(space.material(cell)), kind_(space.kind(cell)), pores_(space.has_pores(cell)) {}

  double at(const FEValuesBase<dim>& fe, unsigned i, unsigned q) const {
    if (load_.kind == LoadKind::source) return pores_ ? -fe[phi_part].value(i, q) : 0.;
    const Tensor<1, dim> u = fe[u_part].value(i, q);
    if (load_.kind == LoadKind::body_force) return load_.direction[0] * u[0] + load_.direction[1] * u[1];
    double value = -material_.rho * u[1];
    if (kind_ == CellKind::inertial) value -= material_.rho_f * fe[W_part].value(i, q)[1];
    if (kind_ == CellKind::darcy)
      value += material_.rho_f / material_.b * material_.vertical_flow * fe[phi_part].gradient(i, q)[1];
    return value;
  }

 private:
  const Load& load_;
  const Material& material_;
  CellKind kind_;
  bool pores_;
};

/// The flow of water that its own weight drives through the open sides of a cell with Darcy flow.
void add_open_sides(const Scene& scene, const Space& space, const Cell& cell, NodalForces& nodal) {
  const Material& material = space.material(cell);
  const Dofs dofs = dofs_of(cell);
  for (const unsigned f : cell->face_indices()) {
    if (!drains(scene, space, cell, f)) continue;
    const FaceValues fe(space, cell, f);
    for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
      const double flux = -material.rho_f / material.b * material.vertical_flow * fe.normal_vector(q)[1] * fe.JxW(q);
      for (unsigned i = 0; i < dofs.size(); ++i)
        if (const double phi = fe[phi_part].value(i, q); phi != 0.) nodal[dofs[i]] += flux * phi;
    }
  }
}

}  // namespace

bool acts_on(const Load& load, const std::string& region) {
  return load.region.empty() || load.region == region;
}

std::map<std::string, NodalForces> volume_forces(const Scene& scene, const Space& space, const Load& load) {
  std::map<std::string, NodalForces> forces;
  const hp::QCollection<dim> quadrature(QGauss<dim>(static_cast<unsigned>(space.degree()) + 1));
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), quadrature,
                              update_values | update_gradients | update_JxW_values);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const std::string& region = space.mesh().surface_of(cell);
    if (!acts_on(load, region) || space.kind(cell) == CellKind::absent) continue;
    const bool weighed_as_body = load.kind == LoadKind::gravity && space.region(cell).kind == RegionKind::rigid;
    if (weighed_as_body) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    const Density density(load, space, cell);
    const Dofs dofs = dofs_of(cell);
    NodalForces& nodal = forces[region];
    for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
      for (unsigned i = 0; i < dofs.size(); ++i)
        if (const double value = density.at(fe, i, q); value != 0.) nodal[dofs[i]] += value * fe.JxW(q);
    if (load.kind == LoadKind::gravity && space.kind(cell) == CellKind::darcy)
      add_open_sides(scene, space, cell, nodal);
  }
  return forces;
}

}  // namespace upbead
