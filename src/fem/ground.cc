#include "fem/ground.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <limits>

#include "algebra/factorisation.h"
#include "fem/assembly.h"
#include "fem/caisson/caisson.h"
#include "fem/faces.h"
#include "fem/loaded_ground.h"
#include "fem/surcharge.h"

namespace upbead {

using namespace dealii;

namespace {

std::vector<bool> water_cells(const Scene& scene, const Mesh& mesh) {
  std::vector<bool> absent;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    absent.push_back(scene.regions.at(mesh.surface_of(cell)).kind == RegionKind::water);
  return absent;
}

bool is_cut(const Cell& cell, double level) {
  bool above = false, below = false;
  for (const unsigned v : cell->vertex_indices()) (cell->vertex(v)[1] > level ? above : below) = true;
  return above && below;
}

}  // namespace

double unit_weight(const Region& region, const Scene& scene, double density, bool below_water) {
  const double rho_f = below_water ? scene.fluid.density : 0.;
  if (region.kind == RegionKind::porous)
    return (1. - *region.porosity) * (*region.grain_density - rho_f) * scene.gravity;
  return (density - rho_f) * scene.gravity;
}

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
  // at rest the ground beyond a far side bears as much as the ground here: no side carries its weight
  for (auto& [name, boundary] : scene.boundaries)
    if (boundary.displacement == DisplacementCondition::absorbing ||
        boundary.displacement == DisplacementCondition::level)
      boundary.displacement = DisplacementCondition::roller;
  return scene;
}

Ground::Ground(const Scene& scene, const Mesh& mesh, const SoilState& soil, bool with_interface)
    : scene_(scene),
      space_(mesh, scene, water_cells(scene, mesh), soil),
      bodies_(rigid_bodies(space_)),
      interface_(with_interface ? interface_nodes(space_) : std::vector<InterfaceNode>()),
      unknowns_(space_, scene, bodies_, interface_) {}

std::vector<Vector> Ground::displace(const std::vector<Vector>& forces) const {
  System system;
  system.field = unknowns_.field();
  assemble(scene_, space_, unknowns_, bodies_, nullptr, system);
  const Factorisation factors(system.K);
  std::vector<Vector> x;
  for (const Vector& f : forces) x.push_back(factors.solve(f));
  return x;
}

std::vector<std::array<double, dim>> Ground::moved(const Vector& x) const {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, dim>> moved(space_.mesh().triangulation.n_vertices(), {nothing, nothing});
  const Vector u = unknowns_.expand(x);
  for (const auto& cell : space_.dofs().active_cell_iterators()) {
    if (space_.kind(cell) == CellKind::absent) continue;
    for (const unsigned v : cell->vertex_indices())
      for (unsigned d = 0; d < dim; ++d)
        moved[cell->vertex_index(v)][d] =
            u[static_cast<Eigen::Index>(cell->vertex_dof_index(v, d, cell->active_fe_index()))];
  }
  return moved;
}

Vector Ground::normal_forces(const Vector& weights) const {
  System system;
  system.field = unknowns_.field();
  assemble(scene_, space_, unknowns_, bodies_, nullptr, system, {}, interface_);
  const int n = unknowns_.n_free(), nodes = static_cast<int>(interface_.size());
  const SparseMatrix rows = system.K.topRows(n);
  const SparseMatrix K = rows.leftCols(n);
  Vector x = Vector::Zero(unknowns_.size());
  x.head(n) = Factorisation(K).solve(weights.head(n));
  return (system.K * x - weights).tail(nodes);
}

WeightInWater Ground::caisson_in_water(double level) const {
  const Vector f = weights(level, true);
  const std::size_t b = caisson_body().value();
  // a unit rotation moves a point upwards by -(x - x_G)
  const double weight = -f[unknowns_.coordinate(b, motion_y)];
  return {weight, bodies_[b].centre[0] + f[unknowns_.coordinate(b, motion_rotation)] / weight};
}

std::optional<std::size_t> Ground::caisson_body() const {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].region == caisson_name) return b;
  return std::nullopt;
}

std::optional<BaseResultant> Ground::base_load(double level) const {
  const std::optional<std::size_t> b = caisson_body();
  const std::optional<Caisson> caisson = b ? find_caisson(space_) : std::nullopt;
  if (!caisson) return std::nullopt;
  const Vector f = weights(level, true);
  const auto of = [&](Motion motion) { return f[unknowns_.coordinate(*b, motion)]; };
  // a unit rotation about the bottom's middle moves the centre of gravity by `arm`
  const Tensor<1, dim> arm = unit_motion(motion_rotation, bodies_[*b].centre, caisson->bottom_centre);
  return BaseResultant{-of(motion_y), of(motion_rotation) + arm[0] * of(motion_x) + arm[1] * of(motion_y),
                       caisson->bottom_width};
}

std::optional<std::array<double, n_motions>> Ground::caisson_motion(const Vector& x) const {
  const std::optional<std::size_t> b = caisson_body();
  if (!b) return std::nullopt;
  std::array<double, n_motions> motion{};
  for (int m = 0; m < n_motions; ++m) motion[static_cast<std::size_t>(m)] = x[unknowns_.coordinate(*b, m)];
  return motion;
}

void Ground::each_work(double level, bool of_caisson_alone,
                       const std::function<void(const Cell&, dealii::types::global_dof_index, double)>& visit) const {
  // the unit weight jumps where the water level cuts a cell: many points of quadrature there
  const hp::QCollection<dim> points(QGauss<dim>(static_cast<unsigned>(space_.degree()) + 1),
                                    QIterated<dim>(QGauss<1>(3), 16));
  hp::FEValues<dim> hp_values(space_.dofs().get_fe_collection(), points,
                              update_values | update_quadrature_points | update_JxW_values);
  for (const auto& cell : space_.dofs().active_cell_iterators()) {
    if (space_.kind(cell) == CellKind::absent || (of_caisson_alone && !is_of_caisson(cell))) continue;
    hp_values.reinit(cell, is_cut(cell, level) ? 1 : 0);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    const Dofs dofs = dofs_of(cell);
    for (const unsigned i : fe.dof_indices()) visit(cell, dofs[i], work_of(fe, i, cell, level));
  }
}

double Ground::weight(double level) const {
  double sum = 0.;
  each_work(level, false, [&](const Cell&, types::global_dof_index, double work) { sum -= work; });
  for_each_surcharge(scene_, space_, [&](const Cell&, const std::vector<double>& force) {
    for (const double work : force) sum += -work;
  });
  if (const std::optional<Caisson> caisson = find_caisson(space_)) sum += still_water(scene_, *caisson).weight;
  return sum;
}

Vector Ground::weights(double level, bool of_caisson_alone) const {
  Vector f = Vector::Zero(unknowns_.size());
  each_work(level, of_caisson_alone, [&](const Cell& cell, types::global_dof_index dof, double work) {
    const Row& row = is_of_caisson(cell) ? unknowns_.caisson_expansion(dof) : unknowns_.expansion(dof);
    for (const auto& [unknown, weight] : row) f[unknown] += weight * work;
  });
  for (std::size_t b = 0; b < bodies_.size(); ++b)  // weights act at centres of gravity, not at middles of areas
    if (!of_caisson_alone || bodies_[b].region == caisson_name)
      f[unknowns_.coordinate(b, motion_rotation)] -=
          bodies_[b].mass * scene_.gravity * (bodies_[b].middle[0] - bodies_[b].centre[0]);
  add_still_water(f);
  if (!of_caisson_alone)
    for_each_surcharge(scene_, space_, [&](const Cell& cell, const std::vector<double>& force) {
      const Dofs dofs = dofs_of(cell);
      for (std::size_t i = 0; i < dofs.size(); ++i)
        for (const auto& [unknown, weight] : unknowns_.expansion(dofs[i])) f[unknown] += weight * force[i];
    });
  return f;
}

Vector Ground::forces_on_caisson(const BaseForces& base) const {
  const std::size_t b = caisson_body().value();
  const Tensor<1, dim> arm = base.middle - bodies_[b].centre;
  Vector f = Vector::Zero(unknowns_.size());
  f[unknowns_.coordinate(b, motion_x)] = base.shear;
  f[unknowns_.coordinate(b, motion_y)] = -base.normal;
  f[unknowns_.coordinate(b, motion_rotation)] = base.moment + base.shear * arm[1] + base.normal * arm[0];
  return f;
}

std::pair<Tensor<1, dim>, double> Ground::motion_of_caisson(const Vector& x, const Point<dim>& at) const {
  const auto motions = caisson_motion(x).value();
  Tensor<1, dim> moved;
  for (int motion = 0; motion < n_motions; ++motion)
    moved += motions[static_cast<std::size_t>(motion)] * unit_motion(motion, at, bodies_[*caisson_body()].centre);
  return {moved, motions[motion_rotation]};
}

void Ground::add_still_water(Vector& f) const {
  const std::optional<Caisson> caisson = find_caisson(space_);
  if (!caisson) return;
  const StillWater still = still_water(scene_, *caisson);
  if (still.push == 0. && still.weight == 0.) return;
  const std::size_t b = caisson_body().value();
  const auto add = [&](Motion motion, double work) { f[unknowns_.coordinate(b, motion)] += work; };
  // a unit rotation about x_G, overturning landward, moves a point by (y - y_G, -(x - x_G))
  const double below = caisson->bottom_centre[1] - bodies_[b].centre[1];
  const double landward = caisson->bottom_centre[0] + caisson->bottom_width / 6. - bodies_[b].centre[0];
  add(motion_x, still.push);
  add(motion_y, -still.weight);
  add(motion_rotation, still.push_moment + still.push * below + still.weight * landward);
}

double Ground::work_of(const FEValues<dim>& fe, unsigned i, const Cell& cell, double level) const {
  const Region& region = space_.region(cell);
  double work = 0.;
  for (const unsigned q : fe.quadrature_point_indices())
    if (const double v = fe[u_part].value(i, q)[1]; v != 0.)
      work -= unit_weight(region, scene_, density(cell), fe.quadrature_point(q)[1] < level) * fe.JxW(q) * v;
  return work;
}

double Ground::density(const Cell& cell) const {
  for (const Body& body : bodies_)
    if (body.region == space_.mesh().surface_of(cell)) return body.mass / body.area;
  return space_.region(cell).density.value_or(0.);
}

EffectiveStress Ground::stress(const Vector& values) const {
  const std::size_t n = space_.mesh().triangulation.n_active_cells();
  const std::vector<double> none(n, 0.);
  EffectiveStress s{none, none, none, none};
  dealii::Vector<double> u(values.begin(), values.end());
  const hp::QCollection<dim> middle{QMidpoint<dim>()};
  hp::FEValues<dim> hp_values(space_.dofs().get_fe_collection(), middle, update_gradients);
  std::vector<SymmetricTensor<2, dim>> strain(1);
  for (const auto& cell : space_.dofs().active_cell_iterators()) {
    if (!space_.has_matrices(cell)) continue;
    hp_values.reinit(cell);
    hp_values.get_present_fe_values()[u_part].get_function_symmetric_gradients(u, strain);
    const PlaneStress stress = space_.material(cell).stress({strain[0][0][0], strain[0][1][1], strain[0][0][1]});
    const std::size_t i = cell->active_cell_index();
    s.horizontal[i] = -stress.xx;
    s.vertical[i] = -stress.yy;
    s.out_of_plane[i] = -stress.zz;
    s.shear[i] = -stress.xy;
  }
  return s;
}

}  // namespace upbead
