#include "fem/settling.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <cmath>

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
  if (!caisson) return found;
  std::vector<Vector> forces;
  for (const std::vector<double>& strain : strains) forces.push_back(forces_of(ground, strain));
  const std::vector<Vector> x = ground.displace(forces);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [moved, rotation] = ground.motion_of_caisson(x[i], caisson->bottom_centre);
    found[i] = SettledBody{-moved[1], rotation};
  }
  return found;
}

}  // namespace upbead
