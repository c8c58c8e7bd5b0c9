#include "fem/assembly.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "algebra/pattern_sums.h"
#include "fem/caisson/springs.h"
#include "fem/caisson/wall_water.h"
#include "fem/kernels.h"
#include "fem/sides.h"

namespace upbead {

using namespace dealii;

namespace {

/// By active cell index, twelve times the unknowns for which a cell counts: one that several cells hold counts for each
/// of them in part. 0 for a rigid or absent cell, which is not solved for.
std::vector<unsigned> weights_of(const Space& space) {
  std::vector<unsigned> holders(space.dofs().n_dofs(), 0), weights;
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (space.has_matrices(cell))
      for (const auto dof : dofs_of(cell)) ++holders[dof];
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    double sum = 0.;
    if (space.has_matrices(cell))
      for (const auto dof : dofs_of(cell)) sum += 12. / holders[dof];
    weights.push_back(static_cast<unsigned>(std::lround(sum)));
  }
  return weights;
}

/// Pairs of cells with a common face, where a cut between processes would cost something. A face between cells of two
/// sizes counts once.
SparsityPattern neighbours(const Space& space, const std::vector<unsigned>& weights) {
  DynamicSparsityPattern pattern(static_cast<unsigned>(weights.size()));
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f) || !cell->neighbor(f)->is_active()) continue;
      const unsigned i = cell->active_cell_index(), j = cell->neighbor(f)->active_cell_index();
      if (weights[i] == 0 || weights[j] == 0) continue;
      pattern.add(i, j);
      pattern.add(j, i);
    }
  SparsityPattern compressed;
  compressed.copy_from(pattern);
  return compressed;
}

}  // namespace

std::vector<bool> own_cells(const Space& space, const Processes& processes) {
  const std::vector<unsigned> weights = weights_of(space);
  std::vector<unsigned> owner(weights.size(), 0);
  SparsityTools::partition(neighbours(space, weights), weights, static_cast<unsigned>(processes.count()), owner,
                           SparsityTools::Partitioner::metis);
  std::vector<bool> own;
  for (const unsigned process : owner) own.push_back(process == static_cast<unsigned>(processes.rank()));
  return own;
}

namespace {

using Rows = std::vector<const Row*>;

/// Number of each matrix in PatternSums.
enum Sum : int { sum_M, sum_C, sum_K, n_sums };

/// M, C and K of the whole system, from cells that deform, faces, and rigid bodies. First expect() tells for each of
/// them which unknowns it couples.
class Assembly {
 public:
  explicit Assembly(const Unknowns& unknowns) : unknowns_(unknowns) {}

  void expect(const Dofs& dofs) { expect(rows_of(dofs)); }
  void expect(const FaceTerms& face) { expect(rows_of(face)); }
  void expect(const std::vector<Body>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int m = 0; m < n_motions; ++m) groups_.push_back({unknowns_.coordinate(b, m)});
  }
  /// Call between the last expect() and the first add().
  void begin() {
    sums_.emplace(unknowns_.size(), n_sums, groups_);
    groups_.clear();
  }

  void add(const CellMatrices& cell, const Dofs& dofs) { scatter(cell, rows_of(dofs)); }
  void add(const FaceTerms& face) { scatter(face.matrices, rows_of(face)); }
  /// Adds an absorbing face, to the radiation too.
  void add_absorbing(const FaceTerms& face) {
    add(face);
    const Rows rows = rows_of(face.dofs);
    for (unsigned i = 0; i < rows.size(); ++i)
      for (unsigned j = 0; j < rows.size(); ++j)
        for (const auto& [row, a] : *rows[i])
          for (const auto& [column, b] : *rows[j])
            if (face.matrices.C(i, j) != 0.) radiation_.emplace_back(row, column, a * b * face.matrices.C(i, j));
  }

  void add(const std::vector<Body>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int m = 0; m < n_motions; ++m) {
        const int i = unknowns_.coordinate(b, m);
        sums_->begin_row(i);
        sums_->add(sum_M, i, m == motion_rotation ? bodies[b].moment_of_inertia : bodies[b].mass);
      }
  }

  void write(System& system) const {
    sums_->matrix(sum_M).swap(system.M);  // Eigen copies a matrix where others move
    sums_->matrix(sum_C).swap(system.C);
    sums_->matrix(sum_K).swap(system.K);
    system.radiation.resize(unknowns_.size(), unknowns_.size());
    system.radiation.setFromTriplets(radiation_.begin(), radiation_.end());
  }

 private:
  Rows rows_of(const Dofs& dofs, bool of_caisson = false) const {
    Rows rows;
    for (const auto dof : dofs)
      rows.push_back(of_caisson ? &unknowns_.caisson_expansion(dof) : &unknowns_.expansion(dof));
    return rows;
  }

  Rows rows_of(const FaceTerms& face) {
    Rows rows = rows_of(face.dofs, face.of_caisson);
    for (const int unknown : face.prescribed) rows.push_back(&(prescribed_[unknown] = {{unknown, 1.}}));
    return rows;
  }

  void expect(const Rows& rows) {
    std::vector<int> group;
    for (const Row* row : rows)
      for (const auto& entry : *row) group.push_back(entry.first);
    groups_.push_back(std::move(group));
  }

  /// Adds local matrices: each row and column is distributed to the unknowns of its expansion.
  void scatter(const CellMatrices& local, const Rows& rows) {
    for (unsigned i = 0; i < rows.size(); ++i)
      for (const auto& [row, a] : *rows[i]) {
        sums_->begin_row(row);
        for (unsigned j = 0; j < rows.size(); ++j)
          for (const auto& [column, b] : *rows[j]) {
            sums_->add(sum_M, column, a * b * local.M(i, j));
            sums_->add(sum_C, column, a * b * local.C(i, j));
            sums_->add(sum_K, column, a * b * local.K(i, j));
          }
      }
  }

  const Unknowns& unknowns_;
  std::vector<std::vector<int>> groups_;
  std::map<int, Row> prescribed_;
  std::optional<detail::PatternSums> sums_;
  std::vector<Eigen::Triplet<double>> radiation_;
};

/// Assembles own cells; for `forces` also the cells that touch the caisson, whoever owns them.
void assemble_cells(const Scene& scene, const Space& space, CaissonForces* forces,
                    const std::function<bool(unsigned)>& is_own, bool own_forces, Assembly& assembly) {
  const hp::QCollection<dim> quadrature(QGauss<dim>(static_cast<unsigned>(space.degree()) + 1));
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), quadrature,
                              update_values | update_gradients | update_JxW_values);
  CellMatrices cell_matrices;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_matrices(cell)) continue;
    const Dofs dofs = dofs_of(cell);
    const bool own = is_own(cell->active_cell_index());
    const bool ground = forces && space.mesh().surface_of(cell) != caisson_name && forces->ground.has_any(dofs);
    if (!own && (own_forces || !ground)) continue;
    hp_values.reinit(cell);
    assemble_cell(hp_values.get_present_fe_values(), space.material(cell), space.kind(cell), scene.time.inertia,
                  cell_matrices);
    if (own) assembly.add(cell_matrices, dofs);
    if (ground) forces->add_ground(cell_matrices, dofs);
  }
}

/// Visits faces between regions or at the outside. `add` takes all of them but absorbing faces.
struct VisitFaces {
  VisitFace add, add_absorbing;
  std::function<void(const WetFace&, const FaceTerms&)> see_wet;
  bool materials_alone = false;
};

void for_each_face(const Scene& scene, const Space& space, const Unknowns& unknowns,
                   const std::vector<InterfaceNode>& interface, const VisitFaces& visit) {
  for_each_open_face(scene, space, unknowns, visit.add);
  for_each_absorbing_face(scene, space,
                          [&](const Cell&, const std::string&, const FaceTerms& terms) { visit.add_absorbing(terms); });
  if (visit.materials_alone) return;
  for_each_surface_face(scene, space, visit.add);
  for_each_sprung_face(scene, space, visit.add);
  if (!interface.empty()) for_each_gap_term(space, unknowns, interface, visit.add);
  for_each_wet_face_term(scene, space, [&](const WetFace& face, const FaceTerms& terms) {
    visit.add(terms);
    visit.see_wet(face, terms);
  });
}

}  // namespace

void assemble(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              CaissonForces* forces, System& system, const AssemblyShare& share,
              const std::vector<InterfaceNode>& interface) {
  Assembly assembly(unknowns);
  const auto is_own = [&](unsigned cell) { return share.cells.empty() || share.cells[cell]; };
  const auto if_own = [&](auto&& action) {
    return [&is_own, action](const FaceTerms& terms) {
      if (is_own(terms.cell)) action(terms);
    };
  };
  const bool adds_bodies = scene.time.inertia && share.bodies;
  std::optional<BaseSprings> springs;
  if (forces && is_on_springs(space))
    springs.emplace(scene.regions.at(caisson_name), space, unknowns, bodies, *find_caisson(space));
  std::optional<BesideWalls> walls;
  if (forces && scene.time.inertia && scene.regions.at(caisson_name).added_mass)
    walls.emplace(scene.regions.at(caisson_name), scene.fluid.density, unknowns, bodies, *find_caisson(space));
  const VisitFace expect = if_own([&](const FaceTerms& terms) { assembly.expect(terms); });
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (space.has_matrices(cell) && is_own(cell->active_cell_index())) assembly.expect(dofs_of(cell));
  for_each_face(scene, space, unknowns, interface,
                {expect, expect, [](const WetFace&, const FaceTerms&) {}, share.materials_alone});
  if (adds_bodies) assembly.expect(bodies);
  if (springs) assembly.expect(springs->terms());
  if (walls && share.bodies) assembly.expect(walls->terms());

  assembly.begin();
  assemble_cells(scene, space, forces, is_own, share.materials_alone, assembly);
  for_each_face(scene, space, unknowns, interface,
                {if_own([&](const FaceTerms& terms) { assembly.add(terms); }),
                 if_own([&](const FaceTerms& terms) { assembly.add_absorbing(terms); }),
                 [&](const WetFace& face, const FaceTerms& terms) {
                   if (forces) forces->add(face, space, terms);
                 },
                 share.materials_alone});
  if (adds_bodies) assembly.add(bodies);
  if (springs) {
    assembly.add(springs->terms());
    springs->add_to(forces->ground);
  }
  if (walls && share.bodies) assembly.add(walls->terms());
  if (walls) walls->add_to(*forces);
  assembly.write(system);
}

}  // namespace upbead
