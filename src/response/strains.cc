#include "response/strains.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <cmath>

namespace upbead {

using namespace dealii;

LargestStrains::LargestStrains(const Space& space, const Unknowns& unknowns, const std::vector<bool>& of_interest)
    : largest_(of_interest.size(), 0.) {
  std::vector<Eigen::Triplet<double>> difference, shear;
  const hp::QCollection<dim> middle{QMidpoint<dim>()};
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), middle, update_gradients);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!of_interest[cell->active_cell_index()] || space.kind(cell) == CellKind::absent) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    cell->get_dof_indices(dofs);
    const int row = static_cast<int>(cells_.size());
    for (const unsigned i : fe.dof_indices()) {
      const SymmetricTensor<2, dim> strain = fe[u_part].symmetric_gradient(i, 0);
      for (const auto& [unknown, weight] : unknowns.expansion(static_cast<unsigned>(dofs[i]))) {
        difference.emplace_back(row, unknown, weight * (strain[0][0] - strain[1][1]));
        shear.emplace_back(row, unknown, weight * 2. * strain[0][1]);
      }
    }
    cells_.push_back(cell->active_cell_index());
  }
  for (auto [matrix, entries] : {std::pair{&difference_, &difference}, std::pair{&shear_, &shear}}) {
    matrix->resize(static_cast<Eigen::Index>(cells_.size()), unknowns.size());
    matrix->setFromTriplets(entries->begin(), entries->end());
  }
}

void LargestStrains::see(const State& state, int step, int) {
  if (step == 0) std::fill(largest_.begin(), largest_.end(), 0.);
  const Vector difference = difference_ * state.x, shear = shear_ * state.x;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    largest_[cells_[c]] = std::max(largest_[cells_[c]], std::hypot(difference[i], shear[i]));
  }
}

}  // namespace upbead
