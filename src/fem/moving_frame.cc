#include "fem/moving_frame.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

namespace upbead {

using namespace dealii;

bool moves_frame(const Scene& scene, const Load& load) {
  using D = DisplacementCondition;
  if (!is_motion(load.kind) || !load.shape.empty() || !scene.time.inertia) return false;
  const D own = scene.boundaries.at(load.boundary).displacement;
  if (own != D::fixed && own != D::absorbing) return false;
  for (const auto& [name, side] : scene.boundaries)
    if (side.displacement == D::fixed && name != load.boundary) return false;
  return true;
}

std::map<std::string, NodalForces> damping_by_frame(const Space& space, const Load& load) {
  std::map<std::string, NodalForces> forces;
  const hp::QCollection<dim> quadrature(QGauss<dim>(static_cast<unsigned>(space.degree()) + 1));
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), quadrature, update_values | update_JxW_values);
  Tensor<1, dim> direction;
  for (unsigned d = 0; d < dim; ++d) direction[d] = load.direction[d];
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_matrices(cell) || space.kind(cell) == CellKind::water) continue;
    const Material& m = space.material(cell);
    if (m.mass_damping == 0.) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    const Dofs dofs = dofs_of(cell);
    NodalForces& nodal = forces[space.mesh().surface_of(cell)];
    for (unsigned i = 0; i < dofs.size(); ++i)
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
        if (const double part = fe[u_part].value(i, q) * direction; part != 0.)
          nodal[dofs[i]] += m.mass_damping * m.rho * part * fe.JxW(q);
  }
  return forces;
}

}  // namespace upbead
