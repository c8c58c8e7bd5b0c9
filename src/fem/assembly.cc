#include "fem/assembly.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <functional>

#include "fem/kernels.h"
#include "fem/sides.h"

namespace upbead {

using namespace dealii;

namespace {

/// Degrees of freedom that a cell has to be solved for.
unsigned weight(const Space& space, const DoFHandler<dim>::active_cell_iterator& cell) {
  return space.region(cell).kind == RegionKind::rigid ? 0 : cell->get_fe().n_dofs_per_cell();
}

/// Cells with a common face that a cut between them would cost something; of a face between cells of two sizes, once.
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
  std::vector<unsigned> weights;
  for (const auto& cell : space.dofs().active_cell_iterators()) weights.push_back(weight(space, cell));
  std::vector<unsigned> owner(weights.size(), 0);
  SparsityTools::partition(neighbours(space, weights), weights, static_cast<unsigned>(processes.count()), owner,
                           SparsityTools::Partitioner::metis);
  std::vector<bool> own;
  for (const unsigned process : owner) own.push_back(process == static_cast<unsigned>(processes.rank()));
  return own;
}

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds a local matrix, each of its rows and columns spread over the unknowns of its expansion.
void scatter(const FullMatrix<double>& local, const std::vector<const Row*>& rows, Triplets& triplets) {
  for (unsigned i = 0; i < rows.size(); ++i)
    for (unsigned j = 0; j < rows.size(); ++j) {
      if (local(i, j) == 0.) continue;
      for (const auto& [row, a] : *rows[i])
        for (const auto& [column, b] : *rows[j]) triplets.emplace_back(row, column, a * b * local(i, j));
    }
}

/// M, C and K of the whole system, from cells that deform, faces, and bodies that do not deform.
class Assembly {
 public:
  Assembly(const Unknowns& unknowns, std::size_t n_cells) : unknowns_(unknowns), n_cells_(n_cells) {}

  void add(const CellMatrices& cell, const Dofs& dofs) {
    const std::vector<const Row*> rows = rows_of(dofs);
    ++n_added_;
    for (Triplets* triplets : {&M_, &C_, &K_}) make_room(rows.size() * rows.size(), *triplets);
    scatter(cell.M, rows, M_);
    scatter(cell.C, rows, C_);
    scatter(cell.K, rows, K_);
  }

  void add(const FaceTerms& face) {
    std::vector<const Row*> rows = rows_of(face.dofs, face.of_caisson);
    std::vector<Row> prescribed;
    for (const int unknown : face.prescribed) prescribed.push_back({{unknown, 1.}});
    for (const Row& row : prescribed) rows.push_back(&row);
    scatter(face.matrices.M, rows, M_);
    scatter(face.matrices.C, rows, C_);
    scatter(face.matrices.K, rows, K_);
  }

  /// Adds a face through which waves leave.
  void add_absorbing(const FaceTerms& face) {
    add(face);
    scatter(face.matrices.C, rows_of(face.dofs), radiation_);
  }

  void add(const std::vector<Body>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int m = 0; m < n_motions; ++m) {
        const int i = unknowns_.coordinate(b, m);
        M_.emplace_back(i, i, m == motion_rotation ? bodies[b].moment_of_inertia : bodies[b].mass);
      }
  }

  void write(System& system) const {
    const auto build = [&](SparseMatrix& matrix, const Triplets& triplets) {
      matrix.resize(unknowns_.size(), unknowns_.size());
      matrix.setFromTriplets(triplets.begin(), triplets.end());
    };
    build(system.M, M_);
    build(system.C, C_);
    build(system.K, K_);
    build(system.radiation, radiation_);
  }

 private:
  std::vector<const Row*> rows_of(const Dofs& dofs, bool of_caisson = false) const {
    std::vector<const Row*> rows;
    for (const auto dof : dofs)
      rows.push_back(of_caisson ? &unknowns_.caisson_expansion(dof) : &unknowns_.expansion(dof));
    return rows;
  }

  /// For what the cells so far let expect, so that little is copied.
  void make_room(std::size_t n_more, Triplets& triplets) const {
    const std::size_t wanted = triplets.size() + n_more;
    if (wanted <= triplets.capacity()) return;
    constexpr double more = 1.05;
    const double expected = more * static_cast<double>(wanted * n_cells_) / static_cast<double>(n_added_);
    triplets.reserve(std::max(3 * wanted / 2, std::min(static_cast<std::size_t>(expected), n_cells_ * n_more)));
  }

  const Unknowns& unknowns_;
  std::size_t n_cells_, n_added_ = 0;
  Triplets M_, C_, K_, radiation_;
};

/// Own cells, and for `forces` those that touch the caisson.
void assemble_cells(const Scene& scene, const Space& space, CaissonForces* forces,
                    const std::function<bool(unsigned)>& is_own, Assembly& assembly) {
  const hp::QCollection<dim> quadrature(QGauss<dim>(static_cast<unsigned>(space.degree()) + 1));
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), quadrature,
                              update_values | update_gradients | update_JxW_values);
  CellMatrices cell_matrices;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_matrices(cell)) continue;
    const Dofs dofs = dofs_of(cell);
    const bool own = is_own(cell->active_cell_index());
    const bool ground = forces && space.mesh().surface_of(cell) != caisson_name && forces->ground.has_any(dofs);
    if (!own && !ground) continue;
    hp_values.reinit(cell);
    assemble_cell(hp_values.get_present_fe_values(), space.material(cell), space.kind(cell), scene.time.inertia,
                  cell_matrices);
    if (own) assembly.add(cell_matrices, dofs);
    if (ground) forces->add_ground(cell_matrices, dofs);
  }
}

}  // namespace

void assemble(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              CaissonForces* forces, System& system, const std::vector<bool>& own, bool with_bodies,
              const std::vector<InterfaceNode>& interface) {
  Assembly assembly(unknowns, space.dofs().get_triangulation().n_active_cells());
  const auto is_own = [&](unsigned cell) { return own.empty() || own[cell]; };
  assemble_cells(scene, space, forces, is_own, assembly);
  const auto add = [&](const FaceTerms& terms) {
    if (is_own(terms.cell)) assembly.add(terms);
  };
  for_each_open_face(scene, space, unknowns, add);
  for_each_surface_face(scene, space, add);
  for_each_sprung_face(scene, space, add);
  for_each_absorbing_face(scene, space, [&](const Cell&, const std::string&, const FaceTerms& terms) {
    if (is_own(terms.cell)) assembly.add_absorbing(terms);
  });
  if (!interface.empty()) for_each_gap_term(space, unknowns, interface, add);
  for_each_wet_face_term(scene, space, [&](const WetFace& face, const FaceTerms& terms) {
    add(terms);
    if (forces) forces->add(face, space, terms);
  });
  if (scene.time.inertia && with_bodies) assembly.add(bodies);
  assembly.write(system);
}

}  // namespace upbead
