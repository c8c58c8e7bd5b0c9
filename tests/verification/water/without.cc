#include "without.h"

#include <algorithm>

#include "fem/unknowns.h"

namespace upbead::test {

namespace {

/// `to` holds the new index of every unknown; -1 if it was removed.
Row kept(const Row& row, const std::vector<int>& to) {
  Row out;
  for (const auto& [i, weight] : row)
    if (to[static_cast<std::size_t>(i)] >= 0) out.emplace_back(to[static_cast<std::size_t>(i)], weight);
  return out;
}

/// New index of the first remaining unknown from `i` on.
int first_left(int i, const std::vector<int>& to, int n_left) {
  while (i < static_cast<int>(to.size()) && to[static_cast<std::size_t>(i)] < 0) ++i;
  return i < static_cast<int>(to.size()) ? to[static_cast<std::size_t>(i)] : n_left;
}

}  // namespace

System without(const System& system, const std::vector<int>& gone) {
  std::vector<int> to(static_cast<std::size_t>(system.size()), -1);
  std::vector<Eigen::Triplet<double>> entries;
  System out;
  for (int i = 0; i < system.size(); ++i) {
    if (std::find(gone.begin(), gone.end(), i) != gone.end()) continue;
    to[static_cast<std::size_t>(i)] = out.size();
    entries.emplace_back(i, out.size(), 1.);
    out.field.push_back(system.field[static_cast<std::size_t>(i)]);
  }
  SparseMatrix T(system.size(), out.size());
  T.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix T_transposed = T.transpose();
  out.M = T_transposed * system.M * T;
  out.C = T_transposed * system.C * T;
  out.K = T_transposed * system.K * T;
  out.radiation = T_transposed * system.radiation * T;
  for (SystemLoad load : system.loads) {
    load.vector = T_transposed * load.vector;
    if (load.prescribed >= 0) load.prescribed = to[static_cast<std::size_t>(load.prescribed)];
    out.loads.push_back(load);
  }
  for (Reading reading : system.readings) {
    reading.position = kept(reading.position, to);
    reading.velocity = kept(reading.velocity, to);
    reading.acceleration = kept(reading.acceleration, to);
    out.readings.push_back(reading);
  }
  for (const IndexRange& block : system.blocks)
    out.blocks.push_back({first_left(block.begin, to, out.size()), first_left(block.end, to, out.size())});
  out.n_prescribed = system.n_prescribed;
  return out;
}

std::vector<int> unknowns_of(const Compiled& compiled, unsigned component) {
  std::vector<int> found;
  std::vector<dealii::types::global_dof_index> dofs;
  for (const auto& cell : compiled.space.dofs().active_cell_iterators()) {
    if (compiled.space.region(cell).kind == RegionKind::rigid) continue;
    dofs.resize(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (cell->get_fe().system_to_component_index(i).first != component) continue;
      const Row& expansion = compiled.unknowns.expansion(static_cast<unsigned>(dofs[i]));
      if (expansion.size() == 1 && expansion[0].second == 1.) found.push_back(expansion[0].first);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace upbead::test
