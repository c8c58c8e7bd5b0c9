#include "dynamics/joined.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "system/part.h"

namespace upbead {

namespace {

constexpr std::array energy_terms = {&EnergyAccount::work,     &EnergyAccount::kinetic, &EnergyAccount::strain,
                                     &EnergyAccount::fluid,    &EnergyAccount::drag,    &EnergyAccount::damping,
                                     &EnergyAccount::radiated, &EnergyAccount::scheme,  &EnergyAccount::lifted,
                                     &EnergyAccount::friction, &EnergyAccount::plastic};

void add_up(const Layout& layout, std::vector<EnergyAccount>& energy) {
  Vector values(static_cast<Eigen::Index>(energy.size() * energy_terms.size()));
  Eigen::Index next = 0;
  for (const EnergyAccount& account : energy)
    for (const auto term : energy_terms) values[next++] = account.*term;
  layout.add_up(values);
  next = 0;
  double largest_work = 0.;
  for (EnergyAccount& account : energy) {
    for (const auto term : energy_terms) account.*term = values[next++];
    account.largest_work = largest_work = std::max(largest_work, std::abs(account.work));
  }
}

/// Numbers in the whole system of the unknowns that some process has in its basis, ascending.
std::vector<int> unknowns_of_all(const System& part, const Layout& layout, const FieldBasis& basis) {
  Vector found = Vector::Zero(part.part.n_whole);
  for (const auto& [here, number] : part.part.counted)
    if (std::binary_search(basis.unknown.begin(), basis.unknown.end(), here)) found[number] = 1.;
  layout.add_up(found);
  std::vector<int> unknowns;
  for (int i = 0; i < part.part.n_whole; ++i)
    if (found[i] > 0.) unknowns.push_back(i);
  return unknowns;
}

}  // namespace

void add_up(const System& system, Response& response) {
  if (!system.is_divided()) return;
  const Layout layout = layout_of(system);
  for (Eigen::MatrixXd* readings : {&response.ends.reading, &response.balanced.reading, &response.inside.reading})
    layout.add_up(*readings);
  add_up(layout, response.energy);
}

MarchCheckpoint joined(const System& part, MarchCheckpoint checkpoint) {
  if (!part.is_divided()) return checkpoint;
  add_up(part, checkpoint.so_far);
  State& reached = checkpoint.so_far.final_state;
  reached = joined(part, reached);
  State& balanced = checkpoint.memory.balanced.state;
  balanced = joined(part, balanced);
  if (!checkpoint.so_far.energy.empty()) checkpoint.memory.energy = checkpoint.so_far.energy.back();
  return checkpoint;
}

MarchCheckpoint restricted(const System& part, const MarchCheckpoint& whole) {
  if (!part.is_divided()) return whole;
  MarchCheckpoint own = whole;
  own.so_far.final_state = restricted(part, whole.so_far.final_state);
  own.memory.balanced.state = restricted(part, whole.memory.balanced.state);
  if (part.sharing.processes->rank() == 0) return own;
  for (Series Response::*series : {&Response::ends, &Response::balanced, &Response::inside})
    (own.so_far.*series).reading.setZero();
  std::fill(own.so_far.energy.begin(), own.so_far.energy.end(), EnergyAccount());
  own.memory.energy = {};
  return own;
}

FieldBasis joined(const System& part, FieldBasis basis) {
  if (!part.is_divided()) return basis;
  const Layout layout = layout_of(part);
  FieldBasis whole;
  whole.unknown = unknowns_of_all(part, layout, basis);
  whole.coordinate = basis.coordinate;
  const auto n = static_cast<Eigen::Index>(whole.unknown.size());
  whole.unit = Vector::Zero(n);
  whole.vectors = Eigen::MatrixXd::Zero(n, basis.n());
  for (const auto& [here, number] : part.part.counted) {
    const auto at = std::lower_bound(basis.unknown.begin(), basis.unknown.end(), here);
    if (at == basis.unknown.end() || *at != here) continue;
    const auto from = at - basis.unknown.begin();
    const auto to = std::lower_bound(whole.unknown.begin(), whole.unknown.end(), number) - whole.unknown.begin();
    whole.unit[to] = basis.unit[from];
    whole.vectors.row(to) = basis.columns().row(from);
  }
  layout.add_up(whole.unit);
  layout.add_up(whole.vectors);
  return whole;
}

void WholeStates::see(const State& state, int step, int n_steps) {
  observer_.see(part_.is_divided() ? joined(part_, state) : state, step, n_steps);
}

}  // namespace upbead
