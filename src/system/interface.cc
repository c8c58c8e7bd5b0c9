#include "system/interface.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace upbead {

namespace {

constexpr int dropped = -1;

/// Maps old unknowns to new ones: each old unknown becomes one of the new ones, or is always zero.
struct Selection {
  std::vector<int> of_old;
  int size = 0;
};

SparseMatrix select(const SparseMatrix& A, const Selection& selection) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(A.nonZeros()));
  for (int i = 0; i < A.rows(); ++i) {
    const int row = selection.of_old[i];
    if (row == dropped) continue;
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      if (const int column = selection.of_old[entry.col()]; column != dropped)
        entries.emplace_back(row, column, entry.value());
  }
  SparseMatrix B(selection.size, selection.size);
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

Row select(const Row& row, const Selection& selection) {
  std::map<int, double> entries;
  for (const auto& [i, weight] : row)
    if (const int j = selection.of_old[i]; j != dropped) entries[j] += weight;
  return Row(entries.begin(), entries.end());
}

/// Without the last unknowns, which every process holds: those from `n` on here.
PartOfSystem without_last(PartOfSystem part, int n, int n_dropped) {
  part.n_whole = std::max(0, part.n_whole - n_dropped);  // 0 where nothing is divided
  while (!part.counted.empty() && part.counted.back().first >= n) part.counted.pop_back();
  part.number.resize(std::min(part.number.size(), static_cast<std::size_t>(n)));
  return part;
}

/// Selects all members but the number of prescribed unknowns, the interface, and what processes share.
System select(const System& system, const Selection& selection) {
  System out;
  out.M = select(system.M, selection);
  out.C = select(system.C, selection);
  out.K = select(system.K, selection);
  if (system.radiation.size() > 0) out.radiation = select(system.radiation, selection);
  out.field.resize(static_cast<std::size_t>(selection.size));
  for (std::size_t i = 0; i < system.field.size(); ++i)
    if (selection.of_old[i] != dropped) out.field[selection.of_old[i]] = system.field[i];
  out.blocks = system.blocks;
  out.loads = system.loads;
  for (SystemLoad& load : out.loads) {
    const Vector old = std::move(load.vector);
    load.vector = Vector::Zero(selection.size);
    for (Eigen::Index i = 0; i < old.size(); ++i)
      if (const int j = selection.of_old[i]; j != dropped) load.vector[j] += old[i];
    if (load.prescribed >= 0) load.prescribed = selection.of_old[load.prescribed];
  }
  for (const Reading& reading : system.readings) {
    if (reading.name.group == interface_group) continue;
    Reading selected = reading;
    for (Row Reading::*part : {&Reading::position, &Reading::velocity, &Reading::acceleration})
      selected.*part = select(reading.*part, selection);
    out.readings.push_back(std::move(selected));
  }
  return out;
}

Row row_of(const SparseMatrix& A, int i, double sign) {
  Row row;
  for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
    row.emplace_back(static_cast<int>(entry.col()), sign * entry.value());
  return row;
}

/// The residual of a row, times `sign`.
Reading residual(const System& system, int i, double sign, const ReadingName& name, const std::string& description) {
  Reading reading{
      name, "N/m", description, row_of(system.K, i, sign), row_of(system.C, i, sign), row_of(system.M, i, sign), {}};
  for (const SystemLoad& load : system.loads)
    reading.feedthrough.push_back(load.prescribed >= 0 ? 0. : -sign * load.vector[i]);
  return reading;
}

}  // namespace

System bonded(const System& system, bool forces) {
  const int n = system.first_slip(), nodes = system.interface->n_nodes();
  Selection selection{std::vector<int>(static_cast<std::size_t>(system.size()), dropped), n};
  for (int i = 0; i < n; ++i) selection.of_old[i] = i;
  System out = select(system, selection);
  out.n_prescribed = system.n_prescribed - 2 * nodes;
  out.sharing = system.sharing;  // its unknowns, which are free, keep their numbers
  out.part = without_last(system.part, n, 2 * nodes);
  for (int i = 0; forces && i < nodes; ++i)
    for (Reading reading :
         {residual(system, n + i, -1., {interface_group, i, "shear_force"}, "shear force at a node of the interface"),
          residual(system, n + nodes + i, 1., {interface_group, i, "normal_force"},
                   "change of the effective normal force at a node of the interface")}) {
      for (Row Reading::*part : {&Reading::position, &Reading::velocity, &Reading::acceleration})
        reading.*part = select(reading.*part, selection);
      out.readings.push_back(std::move(reading));
    }
  return out;
}

System with_rigid_slip(const System& system) {
  const int free = system.n_free(), nodes = system.interface->n_nodes();
  Selection selection{std::vector<int>(static_cast<std::size_t>(system.size()), dropped), system.first_slip() + 1};
  for (int i = 0; i < system.first_slip(); ++i) selection.of_old[i] = i < free ? i : i + 1;
  for (int i = 0; i < nodes; ++i) selection.of_old[system.first_slip() + i] = free;
  System out = select(system, selection);
  out.n_prescribed = system.n_prescribed - 2 * nodes;
  return out;
}

System with_one_node(const System& system) {
  const int first = system.first_slip(), nodes = system.interface->n_nodes();
  Selection selection{std::vector<int>(static_cast<std::size_t>(system.size()), dropped), first + 2};
  for (int i = 0; i < system.size(); ++i) selection.of_old[i] = i < first ? i : i < first + nodes ? first : first + 1;
  System out = select(system, selection);
  out.n_prescribed = system.n_prescribed - 2 * nodes + 2;
  const Interface& all = *system.interface;
  const double length = std::accumulate(all.length.begin(), all.length.end(), 0.);
  const double middle = std::inner_product(all.length.begin(), all.length.end(), all.position.begin(), 0.) / length;
  out.interface = Interface{{middle}, {length}, Vector::Constant(1, all.normal_force.sum()), all.friction};
  return out;
}

}  // namespace upbead
