#include "static_system.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "upbead/algebra/factorisation.h"
#include "upbead/fem/assembly.h"
#include "upbead/fem/faces.h"

namespace upbead::detail {

using namespace dealii;

namespace {

/// The scene at rest: no pressures, no waves, nothing that leaves.
Scene at_rest(Scene scene) {
  scene.time.inertia = false;
  scene.loads.clear();
  scene.probes.clear();
  for (auto& [name, region] : scene.regions) {
    region.damping.reset();
    if (region.kind == RegionKind::porous) region.flow = Flow::drained;
    if (region.kind == RegionKind::solid) region.deformation = Deformation::elastic;
    if (region.stress_law) region.shear_modulus = region.stress_law->reference;
  }
  for (auto& [name, boundary] : scene.boundaries)
    if (boundary.displacement == DisplacementCondition::absorbing)
      boundary.displacement = DisplacementCondition::roller;
  return scene;
}

std::vector<bool> water_cells(const Scene& scene, const Mesh& mesh) {
  std::vector<bool> absent;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    absent.push_back(scene.regions.at(mesh.surface_of(cell)).kind == RegionKind::water);
  return absent;
}

/// Submerged or not (N/m3); of a rigid body from its mass, spread evenly.
double unit_weight(const Region& region, const Scene& scene, double density, bool below_water) {
  const double rho_f = below_water ? scene.fluid.density : 0.;
  if (region.kind == RegionKind::porous)
    return (1. - *region.porosity) * (*region.grain_density - rho_f) * scene.gravity;
  return (density - rho_f) * scene.gravity;
}

class StaticSystem {
 public:
  StaticSystem(const Scene& scene, const Mesh& mesh, const SoilState& soil)
      : scene_(at_rest(scene)),
        level_(water_level(scene, mesh)),
        space_(mesh, scene_, water_cells(scene_, mesh), soil),
        bodies_(rigid_bodies(space_)),
        unknowns_(space_, scene_, bodies_) {}

  EffectiveStress solve() const {
    System system;
    system.field = unknowns_.field();
    assemble(scene_, space_, unknowns_, bodies_, nullptr, system);
    const Vector x = Factorisation(system.K).solve(weights());
    return stress(unknowns_.expand(x));
  }

 private:
  /// Work of the weights in unit motions of the unknowns.
  Vector weights() const {
    std::map<int, double> work;
    // where the water level cuts a cell its weight jumps: many points there
    const hp::QCollection<dim> points(QGauss<dim>(static_cast<unsigned>(space_.degree()) + 1),
                                      QIterated<dim>(QGauss<1>(3), 16));
    hp::FEValues<dim> hp_values(space_.dofs().get_fe_collection(), points,
                                update_values | update_quadrature_points | update_JxW_values);
    for (const auto& cell : space_.dofs().active_cell_iterators()) {
      const Region& region = space_.region(cell);
      if (space_.kind(cell) == CellKind::absent) continue;
      hp_values.reinit(cell, is_cut(cell) ? 1 : 0);
      const FEValues<dim>& fe = hp_values.get_present_fe_values();
      std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
      cell->get_dof_indices(dofs);
      for (const unsigned q : fe.quadrature_point_indices()) {
        const bool below = fe.quadrature_point(q)[1] < level_;
        const double w = unit_weight(region, scene_, density(cell), below) * fe.JxW(q);
        for (const unsigned i : fe.dof_indices())
          if (const double v = fe[u_part].value(i, q)[1]; v != 0.)
            unknowns_.add_to(work, static_cast<unsigned>(dofs[i]), -w * v);
      }
    }
    Vector f = Vector::Zero(unknowns_.size());
    for (const auto& [i, value] : work) f[i] = value;
    return f;
  }

  bool is_cut(const Cell& cell) const {
    bool above = false, below = false;
    for (const unsigned v : cell->vertex_indices()) (cell->vertex(v)[1] > level_ ? above : below) = true;
    return above && below;
  }

  double density(const Cell& cell) const {
    for (const Body& body : bodies_)
      if (body.region == space_.mesh().surface_of(cell)) return body.mass / body.area;
    return space_.region(cell).density.value_or(0.);
  }

  EffectiveStress stress(const Vector& values) const {
    const std::size_t n = space_.mesh().triangulation.n_active_cells();
    EffectiveStress s{std::vector<double>(n, 0.), std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
    dealii::Vector<double> u(values.begin(), values.end());
    const hp::QCollection<dim> middle{QMidpoint<dim>()};
    hp::FEValues<dim> hp_values(space_.dofs().get_fe_collection(), middle, update_gradients);
    std::vector<SymmetricTensor<2, dim>> strain(1);
    for (const auto& cell : space_.dofs().active_cell_iterators()) {
      const Region& region = space_.region(cell);
      if (region.kind == RegionKind::rigid || space_.kind(cell) == CellKind::absent) continue;
      hp_values.reinit(cell);
      hp_values.get_present_fe_values()[u_part].get_function_symmetric_gradients(u, strain);
      const Material m = material(region, scene_.fluid, scene_.gravity);
      const double pressure = -m.lambda * trace(strain[0]);
      const std::size_t i = cell->active_cell_index();
      s.horizontal[i] = pressure - 2. * m.G * strain[0][0][0];
      s.vertical[i] = pressure - 2. * m.G * strain[0][1][1];
      s.out_of_plane[i] = pressure;
    }
    return s;
  }

  Scene scene_;
  double level_;
  Space space_;
  std::vector<Body> bodies_;
  Unknowns unknowns_;
};

}  // namespace

EffectiveStress static_stress(const Scene& scene, const Mesh& mesh, const SoilState& soil) {
  return StaticSystem(scene, mesh, soil).solve();
}

}  // namespace upbead::detail
