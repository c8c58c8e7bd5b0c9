#include "fem/settling.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>

#include "algebra/factorisation.h"
#include "fem/assembly.h"
#include "fem/caisson/caisson.h"
#include "fem/ground.h"
#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// Nodal forces of the stress that holds these strains back: integral of B^T D (0, -strain, 0).
Vector forces_of(const Ground& ground, const std::vector<double>& strain) {
  const Space& space = ground.space();
  const hp::QCollection<dim> points{QGauss<dim>(static_cast<unsigned>(space.degree()) + 1)};
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), points, update_gradients | update_JxW_values);
  Vector f = Vector::Zero(ground.unknowns().size());
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const double e = strain[cell->active_cell_index()];
    if (!space.has_matrices(cell) || std::isnan(e) || e == 0.) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    const PlaneStress stress = space.material(cell).stress({0., -e, 0.});
    const Dofs dofs = dofs_of(cell);
    for (const unsigned i : fe.dof_indices()) {
      double work = 0.;
      for (const unsigned q : fe.quadrature_point_indices()) {
        const PlaneStrain virtual_strain = strain_of(fe, i, q);
        work += (stress.xx * virtual_strain.xx + stress.yy * virtual_strain.yy + 2. * stress.xy * virtual_strain.xy) *
                fe.JxW(q);
      }
      for (const auto& [unknown, weight] : ground.unknowns().expansion(dofs[i])) f[unknown] += weight * work;
    }
  }
  return f;
}

}  // namespace

std::vector<std::optional<SettledBody>> settled_caisson(const Scene& scene, const Mesh& mesh, const SoilState& soil,
                                                        const std::vector<std::vector<double>>& strains) {
  std::vector<std::optional<SettledBody>> found(strains.size());
  const auto region = scene.regions.find(caisson_name);
  if (region == scene.regions.end() || region->second.kind != RegionKind::rigid) return found;
  const Scene rest = at_rest(scene);
  const Ground ground(rest, mesh, soil);
  const std::optional<Caisson> caisson = find_caisson(ground.space());
  const std::vector<Body> bodies = rigid_bodies(ground.space());
  const auto body = std::find_if(bodies.begin(), bodies.end(), [](const Body& b) { return b.region == caisson_name; });
  if (!caisson || body == bodies.end()) return found;
  System system;
  system.field = ground.unknowns().field();
  assemble(rest, ground.space(), ground.unknowns(), bodies, nullptr, system);
  const Factorisation factors(system.K);
  const auto b = static_cast<std::size_t>(body - bodies.begin());
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const Vector x = factors.solve(forces_of(ground, strains[i]));
    const double rotation = x[ground.unknowns().coordinate(b, motion_rotation)];
    // a unit rotation moves a point upwards by -(x - x_G)
    const double up =
        x[ground.unknowns().coordinate(b, motion_y)] - rotation * (caisson->bottom_centre[0] - body->centre[0]);
    found[i] = SettledBody{-up, rotation};
  }
  return found;
}

}  // namespace upbead
