#include "fem/partition.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

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

}  // namespace upbead
