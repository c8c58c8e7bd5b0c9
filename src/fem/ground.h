// The ground at rest: the scene without waves, drained, with its weights in still water.
#pragma once

#include <deal.II/fe/fe_values.h>

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "fem/static_stage.h"
#include "fem/unknowns.h"

namespace upbead {

/// N' and M' about the middle of a caisson's bottom, overturning landward positive, and the bottom's width.
struct BaseResultant {
  double force = 0., moment = 0., width = 0.;
};

struct BaseForces;

/// The scene at rest: no pressures, no waves, no absorbing sides.
Scene at_rest(Scene scene);

/// Of a region, submerged or in air (N/m3); `density`: of a body, a rigid one's from its mass, spread evenly.
double unit_weight(const Region& region, const Scene& scene, double density, bool below_water);

/// The ground that deforms, with given stiffness; without free water. `scene` is the result of at_rest(), and
/// outlives it.
class Ground {
 public:
  /// `with_interface`: the caisson may open from the ground.
  Ground(const Scene& scene, const Mesh& mesh, const SoilState& soil, bool with_interface = false);

  const Space& space() const { return space_; }
  const Unknowns& unknowns() const { return unknowns_; }
  /// The elastic ground's displacements under nodal forces, and its stresses in given displacements.
  std::vector<Vector> displace(const std::vector<Vector>& forces) const;
  Vector displace(const Vector& weights) const { return displace(std::vector<Vector>{weights}).front(); }
  EffectiveStress stress_in(const Vector& x) const { return stress(unknowns_.expand(x)); }
  EffectiveStress solve(const Vector& weights) const { return stress_in(displace(weights)); }
  /// Displacement of the vertices of the mesh; not numbers where nothing stands.
  std::vector<std::array<double, dim>> moved(const Vector& x) const;
  /// Residuals of the interface's openings: the normal forces at its nodes.
  Vector normal_forces(const Vector& weights) const;
  WeightInWater caisson_in_water(double level) const;
  /// What presses on the base of a rigid caisson; none where it does not stand.
  std::optional<BaseResultant> base_load(double level) const;
  /// Motion of a rigid caisson's centre of gravity (m) and its rotation, by `Motion`; likewise.
  std::optional<std::array<double, n_motions>> caisson_motion(const Vector& x) const;
  /// Work of the weights in unit motions of the unknowns: of all weights, or of the caisson's alone. Still water
  /// stands at `level`.
  Vector weights(double level, bool of_caisson_alone = false) const;
  /// Of all that stands, in still water at `level` (N/m).
  double weight(double level) const;
  /// Work of forces on a rigid caisson's base in unit motions of the unknowns.
  Vector forces_on_caisson(const BaseForces& base) const;
  /// The motion of a rigid caisson at a point, and its rotation, overturning landward positive.
  std::pair<dealii::Tensor<1, dim>, double> motion_of_caisson(const Vector& x, const dealii::Point<dim>& at) const;

 private:
  std::optional<std::size_t> caisson_body() const;  ///< none where no rigid one stands
  bool is_of_caisson(const Cell& cell) const { return space_.mesh().surface_of(cell) == caisson_name; }
  /// Calls visit(cell, degree of freedom, work of the cell's weight in its unit motion).
  void each_work(double level, bool of_caisson_alone,
                 const std::function<void(const Cell&, dealii::types::global_dof_index, double)>& visit) const;
  double work_of(const dealii::FEValues<dim>& fe, unsigned i, const Cell& cell, double level) const;
  /// Adds what still water at two levels does to a rigid caisson.
  void add_still_water(Vector& f) const;
  double density(const Cell& cell) const;
  EffectiveStress stress(const Vector& values) const;

  const Scene& scene_;
  Space space_;
  std::vector<Body> bodies_;
  std::vector<InterfaceNode> interface_;
  Unknowns unknowns_;
};

}  // namespace upbead
