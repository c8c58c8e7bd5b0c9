#include "unknowns_on.h"

#include <algorithm>
#include <stdexcept>

#include "fem/unknowns.h"

namespace upbead::test {

namespace {

Row tied_row(const Row& row, const std::vector<int>& to) {
  std::map<int, double> entries;
  for (const auto& [i, weight] : row) entries[to[static_cast<std::size_t>(i)]] += weight;
  return {entries.begin(), entries.end()};
}

}  // namespace

std::vector<int> unknowns_on(const Compiled& compiled, const std::string& curve, unsigned component) {
  std::vector<int> found;
  for (const auto& cell : compiled.space.dofs().active_cell_iterators()) {
    const auto& fe = cell->get_fe();
    for (const unsigned f : cell->face_indices()) {
      if (compiled.space.mesh().curve_of(cell->face(f)) != curve) continue;
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      for (unsigned i = 0; i < dofs.size(); ++i)
        if (fe.system_to_component_index(i).first == component && fe.has_support_on_face(i, f))
          for (const auto& [unknown, weight] : compiled.unknowns.expansion(static_cast<unsigned>(dofs[i])))
            found.push_back(unknown);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

System tied(const System& system, const std::vector<int>& group) {
  if (!system.blocks.empty() || system.n_prescribed > 0) throw std::invalid_argument("blocks cannot be tied");
  const int n = system.size();
  std::vector<int> to(static_cast<std::size_t>(n));
  std::vector<Eigen::Triplet<double>> entries;
  System out;
  for (int i = 0; i < n; ++i) {
    const bool follows = i != group.front() && std::binary_search(group.begin(), group.end(), i);
    if (!follows) {
      to[static_cast<std::size_t>(i)] = out.size();
      out.field.push_back(system.field[static_cast<std::size_t>(i)]);
    }
  }
  for (const int i : group) to[static_cast<std::size_t>(i)] = to[static_cast<std::size_t>(group.front())];
  for (int i = 0; i < n; ++i) entries.emplace_back(i, to[static_cast<std::size_t>(i)], 1.);
  SparseMatrix T(n, out.size());
  T.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix T_transposed = T.transpose();
  out.M = T_transposed * system.M * T;
  out.C = T_transposed * system.C * T;
  out.K = T_transposed * system.K * T;
  out.loads = system.loads;
  for (SystemLoad& load : out.loads) load.vector = T_transposed * load.vector;
  out.readings = system.readings;
  for (Reading& reading : out.readings) {
    reading.position = tied_row(reading.position, to);
    reading.velocity = tied_row(reading.velocity, to);
    reading.acceleration = tied_row(reading.acceleration, to);
  }
  return out;
}

}  // namespace upbead::test
