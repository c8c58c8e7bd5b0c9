#include "system/part.h"

#include <algorithm>
#include <utility>

#include "upbead/base/error.h"

namespace upbead {

namespace {

void require_one_size(const System& system, const Processes& processes) {
  std::vector<double> sizes(static_cast<std::size_t>(processes.count()), 0.);
  sizes[processes.rank()] = system.size();
  processes.sum(sizes.data(), processes.count());
  if (std::count(sizes.begin(), sizes.end(), sizes[0]) != processes.count())
    throw NumericsError("the processes have meshes of different sizes");
}

/// Per unknown, whether some matrix has an entry in its row.
std::vector<double> touched(const System& system) {
  std::vector<double> found(static_cast<std::size_t>(system.size()), 0.);
  for (const SparseMatrix* matrix : {&system.M, &system.C, &system.K})
    for (int i = 0; i < system.size(); ++i)
      if (matrix->outerIndexPtr()[i + 1] > matrix->outerIndexPtr()[i]) found[i] = 1.;
  return found;
}

/// The unknowns of a system that one process holds.
class Part {
 public:
  Part(const System& system, const std::vector<int>& on_all, const Processes& processes)
      : index(static_cast<std::size_t>(system.size()), -1), is_first_(processes.rank() == 0) {
    const std::vector<double> here = touched(system);
    std::vector<double> holders = here;
    processes.sum(holders.data(), system.size());
    is_shared_.assign(holders.size(), false);
    for (int i = 0; i < system.size(); ++i) is_shared_[i] = holders[i] != 1. || i >= system.n_free();
    for (const int i : on_all) is_shared_[i] = true;
    for (int i = 0; i < system.size(); ++i)
      if (here[i] != 0. || is_shared_[i]) {
        index[i] = static_cast<int>(unknowns.size());
        unknowns.push_back(i);
      }
  }

  bool is_shared(int whole) const { return is_shared_[whole]; }
  /// Whether this process counts for the unknown; exactly one process does.
  bool owns(int whole) const { return is_shared_[whole] ? is_first_ : index[whole] >= 0; }

  std::vector<int> index;     ///< per unknown of the whole system
  std::vector<int> unknowns;  ///< unknowns held, as numbers of the whole system

 private:
  bool is_first_;
  std::vector<bool> is_shared_;
};

SparseMatrix restricted(const SparseMatrix& A, const Part& part) {
  std::vector<int> outer{0}, inner;
  std::vector<double> values;
  for (const int i : part.unknowns) {
    for (SparseMatrix::InnerIterator it(A, i); it; ++it) {
      inner.push_back(part.index[it.col()]);
      values.push_back(it.value());
    }
    outer.push_back(static_cast<int>(inner.size()));
  }
  const auto n = static_cast<Eigen::Index>(part.unknowns.size());
  return Eigen::Map<const SparseMatrix>(n, n, outer.back(), outer.data(), inner.data(), values.data());
}

Vector restricted(const Vector& b, const Part& part) {
  Vector values(static_cast<Eigen::Index>(part.unknowns.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = part.owns(part.unknowns[k]) ? b[part.unknowns[k]] : 0.;
  return values;
}

Row restricted(const Row& row, const Part& part) {
  Row kept;
  for (const auto& [i, weight] : row)
    if (part.owns(i)) kept.emplace_back(part.index[i], weight);
  return kept;
}

void divide_readings(std::vector<Reading>& readings, const Part& part, bool is_first) {
  for (Reading& reading : readings) {
    for (Row* row : {&reading.position, &reading.velocity, &reading.acceleration}) *row = restricted(*row, part);
    if (!is_first) reading.feedthrough.clear();
  }
}

}  // namespace

std::vector<int> divide(System& system, const std::vector<int>& on_all, std::shared_ptr<const Processes> processes) {
  require_one_size(system, *processes);
  const Part part(system, on_all, *processes);
  for (SparseMatrix* matrix : {&system.M, &system.C, &system.K, &system.radiation}) *matrix = restricted(*matrix, part);
  for (SystemLoad& load : system.loads) {
    load.vector = restricted(load.vector, part);
    if (load.prescribed >= 0) load.prescribed = part.index[load.prescribed];
  }
  if (processes->rank() != 0)
    for (FrameDashpots* dashpots : {&system.frame_damping, &system.frame_radiation}) dashpots->own.setZero();
  divide_readings(system.readings, part, processes->rank() == 0);
  std::vector<IndexRange> blocks;
  for (const IndexRange& block : system.blocks)
    if (const int begin = part.index[block.begin]; begin >= 0) blocks.push_back({begin, begin + block.size()});
  system.blocks = std::move(blocks);
  std::vector<Field> field;
  for (const int i : part.unknowns) {
    if (part.is_shared(i) && i < system.n_free()) system.sharing.unknowns.push_back(part.index[i]);
    field.push_back(system.field[i]);
  }
  system.field = std::move(field);
  system.sharing.processes = std::move(processes);
  return part.index;
}

}  // namespace upbead
