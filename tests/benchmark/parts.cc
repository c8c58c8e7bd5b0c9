// Work of each process in factorising and solving a divided scene, without its waiting for others.
//
// usage: mpirun -n N bench_parts CASE [KEY=VALUE]...
//
// The first process prints JSON: processor time (s) of the process with most of it. The interiors take turns, so that
// nothing is waited for; the shared unknowns are factorised and solved by all at once, with the waiting, the least of
// some repetitions. The matrix is M + g C + g^2 K, g a quarter of a hundredth of a second.

#include <mpi.h>
#include <unistd.h>

#include <ctime>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../../src/algebra/condensation.h"
#include "../../src/algebra/ldlt/factor_view.h"
#include "../../src/algebra/ldlt/multifrontal.h"
#include "../../src/algebra/ldlt/triangular_solve.h"
#include "../../src/algebra/shared_matrix.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead {
namespace {

double processor_time() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of some repetitions (s).
double least(int repetitions, const std::function<void()>& work) {
  double found = HUGE_VAL;
  for (int i = 0; i < repetitions; ++i) {
    const double begin = processor_time();
    work();
    found = std::min(found, processor_time() - begin);
  }
  return found;
}

/// Waits without work until all processes are here.
void meet() {
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (int done = 0; done == 0; usleep(10000)) MPI_Test(&request, &done, MPI_STATUS_IGNORE);
}

void in_turns(const Processes* processes, const std::function<void()>& work) {
  for (int k = 0; k < (processes ? processes->count() : 1); ++k) {
    if (!processes || processes->rank() == k) work();
    meet();
  }
}

/// What one process takes (s), and holds.
struct Work {
  double factorise = 0., solve = 0., shared_factorise = 0., shared_solve = 0.;
  double unknowns = 0., shared = 0.;
};

/// 1 / sqrt|a_ii| of the sum of all parts.
Vector scale_of(const SparseMatrix& A, const Sharing& sharing) {
  Vector diagonal = A.diagonal(), shared = Vector::Zero(sharing.n_all);
  for (std::size_t k = 0; k < sharing.unknowns.size(); ++k) shared[sharing.numbers[k]] = diagonal[sharing.unknowns[k]];
  if (sharing.processes) sharing.processes->sum(shared.data(), sharing.n_all);
  for (std::size_t k = 0; k < sharing.unknowns.size(); ++k) diagonal[sharing.unknowns[k]] = shared[sharing.numbers[k]];
  return diagonal.cwiseAbs().cwiseSqrt().cwiseInverse();
}

/// The steps of Factorisation and Ldlt, so that each is timed by itself.
Work work_on(const System& system) {
  const double g = 0.0025;
  const SparseMatrix rows = (system.M + g * system.C + g * g * system.K).topRows(system.n_free());
  const SparseMatrix E = rows.leftCols(system.n_free());
  const Processes* processes = system.sharing.processes.get();
  Sharing sharing = system.sharing;
  Work work;
  work.unknowns = system.n_free();
  work.shared = static_cast<double>(sharing.unknowns.size());
  detail::Condensation condensation(E, system.blocks);
  for (int& i : sharing.unknowns) i = condensation.rest_index(i);
  const detail::Supernodes nodes = detail::find_supernodes(condensation.schur(), sharing.unknowns);
  const detail::PanelEntries entries = detail::find_panel_entries(condensation.schur(), nodes);
  detail::Factor factor = detail::make_factor(nodes);
  condensation.condense(E);
  const Vector scale = scale_of(condensation.schur(), sharing);
  std::vector<double> left;
  const int n_root = nodes.n_root();
  in_turns(processes, [&] {
    work.factorise = least(2, [&] {
      condensation.condense(E);
      SparseMatrix& A = condensation.schur();
      for (int i = 0; i < A.rows(); ++i)
        for (SparseMatrix::InnerIterator it(A, i); it; ++it) it.valueRef() *= scale[i] * scale[it.col()];
      left = detail::factorise(nodes, entries, A.valuePtr(), factor);
    });
  });
  const Vector b = Vector::LinSpaced(E.rows(), -1., 2.);
  Vector x(b.size()), rest(condensation.n_rest()), ordered(condensation.n_rest());
  std::vector<double> space(static_cast<std::size_t>(detail::triangular_solve_work(nodes)));
  in_turns(processes, [&] {
    work.solve = least(7, [&] {
      condensation.reduce(b, rest);
      for (Eigen::Index k = 0; k < rest.size(); ++k) ordered[k] = rest[nodes.order[k]];
      const double* end = forward_half(detail::view(nodes, factor), ordered.data(), 1, space.data());
      backward_half(detail::view(nodes, factor), end, ordered.data(), 1, space.data());
      for (Eigen::Index k = 0; k < rest.size(); ++k) rest[nodes.order[k]] = ordered[k];
      condensation.expand(b, rest, x);
    });
  });
  if (!processes) return work;
  for (int j = 0; j < n_root; ++j)
    for (int i = 0; i < j; ++i) left[i + j * n_root] = left[j + i * n_root];
  const auto root = processes->shared_matrix(sharing);
  root->factorise(left);
  std::vector<double> part(static_cast<std::size_t>(n_root), 1.);
  work.shared_factorise = least(5, [&] { root->factorise(left); });
  work.shared_solve = least(20, [&] { root->solve(part.data()); });
  return work;
}

double largest(double value, const Processes* processes) {
  double most = value;
  if (processes) MPI_Allreduce(&value, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return most;
}

nlohmann::ordered_json measure(const Simulation& scene, const Processes* processes) {
  const Work work = work_on(scene.system());
  double sum = work.unknowns;
  if (processes) processes->sum(&sum, 1);
  const int n = processes ? processes->count() : 1;
  nlohmann::ordered_json json{{"processes", n}};
  for (const auto& [name, value] :
       {std::pair{"factorise", work.factorise}, std::pair{"shared_factorise", work.shared_factorise},
        std::pair{"solve", work.solve}, std::pair{"shared_solve", work.shared_solve},
        std::pair{"unknowns", work.unknowns}, std::pair{"shared", work.shared}})
    json[name] = largest(value, processes);
  json["unknowns_over_mean"] = json["unknowns"].get<double>() / (sum / n);
  return json;
}

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::invalid_argument("usage: bench_parts CASE [KEY=VALUE]...");
    const upbead::PetscSession petsc;
    const auto processes = upbead::started_processes();
    const upbead::Case problem = upbead::read_case(argv[1], std::vector<std::string>(argv + 2, argv + argc));
    const std::shared_ptr<const upbead::Mesh> mesh = upbead::read_mesh(upbead::mesh_request(problem));
    const auto json = upbead::measure(upbead::simulation_of(problem, mesh, processes), processes.get());
    if (!processes || processes->rank() == 0) std::cout << json.dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
