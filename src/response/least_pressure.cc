#include "response/least_pressure.h"

#include <algorithm>
#include <set>

namespace upbead {

using namespace dealii;

namespace {

/// Where the i-th function of a cell has its node.
Point<dim> node_of(const Space& space, const DoFHandler<dim>::active_cell_iterator& cell, unsigned i) {
  const FiniteElement<dim>& fe = cell->get_fe();
  const FiniteElement<dim>& base = fe.base_element(fe.system_to_base_index(i).first.first);
  return space.mapping().transform_unit_to_real_cell(cell, base.unit_support_point(fe.system_to_base_index(i).second));
}

/// Those columns of a sparse matrix alone, in that order.
SparseMatrix columns_of(const SparseMatrix& rows, const std::vector<int>& columns) {
  std::vector<int> place(static_cast<std::size_t>(rows.cols()), -1);
  for (std::size_t j = 0; j < columns.size(); ++j) place[static_cast<std::size_t>(columns[j])] = static_cast<int>(j);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < rows.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(rows, i); entry; ++entry)
      if (const int j = place[static_cast<std::size_t>(entry.col())]; j >= 0)
        entries.emplace_back(static_cast<int>(entry.row()), j, entry.value());
  SparseMatrix part(rows.rows(), static_cast<Eigen::Index>(columns.size()));
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

}  // namespace

LeastPressure::LeastPressure(const Space& space, const Unknowns& unknowns, const Scene& scene, double level) {
  std::vector<Eigen::Triplet<double>> entries;
  std::set<types::global_dof_index> seen;
  std::vector<types::global_dof_index> dofs;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pressure(cell)) continue;
    const FiniteElement<dim>& fe = cell->get_fe();
    dofs.resize(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (fe.system_to_component_index(i).first != phi_component || !seen.insert(dofs[i]).second) continue;
      const Point<dim> at = node_of(space, cell, i);
      if (at[1] > level) continue;
      const int row = static_cast<int>(nodes_.size());
      for (const auto& [unknown, weight] : unknowns.expansion(static_cast<unsigned>(dofs[i])))
        entries.emplace_back(row, unknown, weight);
      nodes_.push_back(
          {at, space.mesh().surface_of(cell), atmosphere + scene.fluid.density * scene.gravity * (level - at[1])});
    }
  }
  rows_.resize(static_cast<Eigen::Index>(nodes_.size()), unknowns.size());
  rows_.setFromTriplets(entries.begin(), entries.end());
}

void LeastPressure::see(const State& state, int step, int) {
  if (step == 0) has_seen_ = false;
  if (watches()) take(rows_ * state.v, state.time);
}

void LeastPressure::see(const PressureModel& model, const SampledLoads& loads, double duration) {
  if (!watches()) return;
  const Series series = respond(model.model, loads);
  std::vector<Eigen::Index> looks;
  for (std::size_t i = 0; i < series.time.size(); ++i)
    if (looks.empty() || series.time[i] - series.time[static_cast<std::size_t>(looks.back())] > duration / 17.)
      looks.push_back(static_cast<Eigen::Index>(i));
  const SparseMatrix of_phi = columns_of(rows_, model.basis.unknown);
  const Eigen::MatrixXd excess = of_phi * phi_velocities(model.basis, series.reading(Eigen::all, looks));
  for (std::size_t i = 0; i < looks.size(); ++i)
    take(excess.col(static_cast<Eigen::Index>(i)), series.time[static_cast<std::size_t>(looks[i])]);
}

std::vector<double> LeastPressure::memory() const {
  return {least_, time_, static_cast<double>(node_), has_seen_ ? 1. : 0.};
}

void LeastPressure::recall(const std::vector<double>& memory) {
  least_ = memory.at(0);
  time_ = memory.at(1);
  node_ = static_cast<std::size_t>(memory.at(2));
  has_seen_ = memory.at(3) != 0.;
}

void LeastPressure::take(const Eigen::Ref<const Vector>& excess, double time) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double p = nodes_[i].still + excess[static_cast<Eigen::Index>(i)];
    if (has_seen_ && p >= least_) continue;
    has_seen_ = true;
    least_ = p;
    time_ = time;
    node_ = i;
  }
}

}  // namespace upbead
