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

/// Whether this process is the first one that holds an unknown; `held` says for each unknown whether it holds it.
std::vector<bool> owned(const std::vector<double>& held, const Processes& processes) {
  const std::size_t n = held.size();
  std::vector<double> before(n, 0.);  // processes of lower rank that hold it
  for (int rank = 0; rank + 1 < processes.count(); ++rank) {
    std::vector<double> of_rank = rank == processes.rank() ? held : std::vector<double>(n, 0.);
    processes.sum(of_rank.data(), static_cast<int>(n));
    if (rank < processes.rank())
      for (std::size_t i = 0; i < n; ++i) before[i] += of_rank[i];
  }
  std::vector<bool> own;
  for (std::size_t i = 0; i < n; ++i) own.push_back(held[i] != 0. && before[i] == 0.);
  return own;
}

/// The unknowns of a system that one process holds.
class Part {
 public:
  Part(const System& system, const std::vector<int>& on_all, const Processes& processes)
      : index(static_cast<std::size_t>(system.size()), -1) {
    const std::vector<double> here = touched(system);
    std::vector<double> holders = here;
    processes.sum(holders.data(), system.size());
    std::vector<bool> everywhere(holders.size(), false);
    for (int i = 0; i < system.size(); ++i) everywhere[i] = holders[i] == 0. || i >= system.n_free();
    for (const int i : on_all) everywhere[i] = true;
    std::vector<double> held_shared;
    for (int i = 0; i < system.size(); ++i) {
      const bool shared = everywhere[i] || holders[i] > 1.;
      shared_number_.push_back(shared ? static_cast<int>(held_shared.size()) : -1);
      if (shared) held_shared.push_back(everywhere[i] ? 1. : here[i]);
      if (shared ? held_shared.back() == 0. : here[i] == 0.) continue;
      index[i] = static_cast<int>(unknowns.size());
      unknowns.push_back(i);
    }
    owns_shared_ = owned(held_shared, processes);
  }

  /// Number among the shared unknowns of all processes; -1 where no other process holds the unknown. Those that are
  /// prescribed are the last ones.
  int shared_number(int whole) const { return shared_number_[whole]; }
  /// Whether this process counts for the unknown; exactly one process does.
  bool owns(int whole) const {
    return shared_number_[whole] >= 0 ? owns_shared_[shared_number_[whole]] : index[whole] >= 0;
  }

  std::vector<int> index;     ///< per unknown of the whole system
  std::vector<int> unknowns;  ///< unknowns held, as numbers of the whole system

 private:
  std::vector<int> shared_number_;
  std::vector<bool> owns_shared_;
};

/// The shared ones among the free unknowns.
Sharing sharing_of(const System& system, const Part& part, std::shared_ptr<const Processes> processes) {
  Sharing sharing;
  sharing.processes = std::move(processes);
  for (int i = 0; i < system.n_free(); ++i) {
    const int number = part.shared_number(i);
    if (number < 0) continue;
    ++sharing.n_all;
    if (part.index[i] < 0) continue;
    sharing.unknowns.push_back(part.index[i]);
    sharing.numbers.push_back(number);
  }
  return sharing;
}

SparseMatrix restricted(const SparseMatrix& A, const Part& part) {
  const auto n = static_cast<Eigen::Index>(part.unknowns.size());
  SparseMatrix own(n, n);
  own.reserve(A.nonZeros());
  for (Eigen::Index k = 0; k < n; ++k) {
    own.startVec(k);
    for (SparseMatrix::InnerIterator it(A, part.unknowns[k]); it; ++it)
      own.insertBack(k, part.index[it.col()]) = it.value();
  }
  own.finalize();
  return own;
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
  for (SparseMatrix* matrix : {&system.M, &system.C, &system.K, &system.radiation})
    restricted(*matrix, part).swap(*matrix);
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
  system.sharing = sharing_of(system, part, std::move(processes));
  system.part.n_whole = system.size();
  system.part.number = part.unknowns;
  for (int i = 0; i < system.size(); ++i) {
    if (part.owns(i)) system.part.counted.emplace_back(part.index[i], i);
    system.part.n_phi_elsewhere +=
        part.index[i] < 0 && i < system.n_free() && system.field[i] == Field::pressure_impulse;
  }
  std::vector<Field> field;
  for (const int i : part.unknowns) field.push_back(system.field[i]);
  system.field = std::move(field);
  return part.index;
}

Layout layout_of(const System& system) {
  if (!system.is_divided()) return {};
  std::vector<int> elsewhere;
  auto counted = system.part.counted.begin();
  for (int i = 0; i < system.size(); ++i)
    if (counted != system.part.counted.end() && counted->first == i)
      ++counted;
    else
      elsewhere.push_back(i);
  return {system.sharing.processes, std::move(elsewhere)};
}

Vector values_of(const System& system, Vector parts) {
  if (!system.is_divided()) return parts;
  const Sharing& sharing = system.sharing;
  Vector shared = Vector::Zero(sharing.n_all);
  for (std::size_t k = 0; k < sharing.unknowns.size(); ++k) shared[sharing.numbers[k]] = parts[sharing.unknowns[k]];
  sharing.processes->sum(shared.data(), sharing.n_all);
  for (std::size_t k = 0; k < sharing.unknowns.size(); ++k) parts[sharing.unknowns[k]] = shared[sharing.numbers[k]];
  return parts;
}

bool counts_for_prescribed(const System& system) {
  return !system.is_divided() || system.sharing.processes->rank() == 0;
}

int whole_size(const System& system) {
  return system.is_divided() ? system.part.n_whole : system.size();
}

State joined(const System& part, const State& state) {
  State whole;
  whole.time = state.time;
  for (Vector State::*values : {&State::x, &State::v, &State::a}) {
    Vector& all = whole.*values = Vector::Zero(part.part.n_whole);
    for (const auto& [here, number] : part.part.counted) all[number] = (state.*values)[here];
    part.sharing.processes->sum(all.data(), part.part.n_whole);
  }
  return whole;
}

State restricted(const System& part, const State& whole) {
  State state;
  state.time = whole.time;
  for (Vector State::*values : {&State::x, &State::v, &State::a}) {
    Vector here = Vector::Zero(part.size());
    for (const auto& [own, number] : part.part.counted) here[own] = (whole.*values)[number];
    here = values_of(part, std::move(here));
    here.tail(part.n_prescribed) = (whole.*values).tail(part.n_prescribed);
    state.*values = std::move(here);
  }
  return state;
}

}  // namespace upbead
