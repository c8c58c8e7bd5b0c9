#include "fem/moving_frame.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <cmath>

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

LevelSides level_sides(const Scene& scene) {
  bool along = false, across = false;
  for (const auto& [name, load] : scene.loads) {
    if (!is_motion(load.kind) || load.factor == 0.) continue;
    along = along || std::abs(load.direction[0]) > 1e-9;
    across = across || std::abs(load.direction[1]) > 1e-9;
  }
  if (along && across) return LevelSides::move_alike;
  return across ? LevelSides::hold_horizontally : LevelSides::hold_vertically;
}

namespace {

bool is_damped_by_mass(const Space& space, const Cell& cell) {
  return space.has_matrices(cell) && space.kind(cell) != CellKind::water && space.material(cell).mass_damping != 0.;
}

}  // namespace

double frame_damping(const Space& space, const Load& one, const Load& other) {
  double sum = 0.;
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (is_damped_by_mass(space, cell))
      sum += space.material(cell).mass_damping * space.material(cell).rho * area_of(cell);
  return sum * (one.direction[0] * other.direction[0] + one.direction[1] * other.direction[1]);
}

std::map<std::string, NodalForces> damping_by_frame(const Space& space, const Load& load) {
  std::map<std::string, NodalForces> forces;
  const hp::QCollection<dim> quadrature(QGauss<dim>(static_cast<unsigned>(space.degree()) + 1));
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), quadrature, update_values | update_JxW_values);
  Tensor<1, dim> direction;
  for (unsigned d = 0; d < dim; ++d) direction[d] = load.direction[d];
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!is_damped_by_mass(space, cell)) continue;
    const Material& m = space.material(cell);
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
