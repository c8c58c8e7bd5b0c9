// Time of analysis, factorisation and solution of one scene's effective matrix by our solver and by others, and the
// lower bound that the bandwidth of the machine sets.
//
// usage: bench_solves CASE [KEY=VALUE]...
//
// Prints JSON. All solvers have the same matrix: M + g C + g^2 K with g a quarter of a hundredth of a second, cell
// blocks condensed, equilibrated. The bound of a solve is the time to read the factor twice, each entry as stored, at
// the bandwidth of a read stream: once for an array far larger than the caches, and once for an array as large as the
// factor.

#include <cholmod.h>
#include <petscmat.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../../src/algebra/condensation.h"
#include "../../src/algebra/ldlt/ldlt.h"
#include "base/stopwatch.h"
#include "fem/compile.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead {
namespace {

using Json = nlohmann::ordered_json;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median of several runs (s), of at least a tenth of a second together.
double median_time(const std::function<void()>& run) {
  std::vector<double> seconds;
  const Stopwatch all;
  while (seconds.size() < 11 || (all.seconds() < 0.1 && seconds.size() < 1001)) {
    const Stopwatch watch;
    run();
    seconds.push_back(watch.seconds());
  }
  return median(seconds);
}

double once(const std::function<void()>& run) {
  const Stopwatch watch;
  run();
  return watch.seconds();
}

/// Sum of an array, in as many independent chains as fit in the registers of every processor, so that only memory
/// limits the speed.
[[gnu::noipa]] double sum_of(const double* values, std::size_t n) {
  constexpr std::size_t chains = 16;
  double sum[chains] = {};
  for (std::size_t i = 0; i + chains <= n; i += chains)
    for (std::size_t k = 0; k < chains; ++k) sum[k] += values[i + k];
  double total = 0.;
  for (const double part : sum) total += part;
  return total;
}

/// An array to read through.
class Stream {
 public:
  explicit Stream(std::size_t n) : size_(n), values_(detail::make_big_array(n)) { std::fill_n(values_.get(), n, 1.); }
  void read() { sink_ = sum_of(values_.get(), size_); }
  double bytes() const { return static_cast<double>(size_) * sizeof(double); }

 private:
  std::size_t size_;
  detail::BigArray values_;
  volatile double sink_ = 0.;
};

/// The same matrix for all.
struct Problem {
  SparseMatrix A;  ///< equilibrated
  Vector b;
};

/// Largest |b - A x| over |A||x| + |b|, row by row.
double residual(const Problem& p, const Vector& x) {
  const Vector r = p.b - p.A * x, size = p.A.cwiseAbs() * x.cwiseAbs() + p.b.cwiseAbs();
  return (r.array() / size.array()).abs().maxCoeff();
}

SparseMatrix effective_matrix(const System& system, double g) {
  const SparseMatrix E = system.M + g * system.C + g * g * system.K, rows = E.topRows(system.n_free());
  return rows.leftCols(system.n_free());
}

Problem condensed(const SparseMatrix& E, const std::vector<IndexRange>& blocks) {
  detail::Condensation condensation(E, blocks);
  condensation.condense(E);
  SparseMatrix A = condensation.schur();
  const Vector scale = A.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  A = SparseMatrix(scale.asDiagonal() * A * scale.asDiagonal());
  return {A, Vector::LinSpaced(A.rows(), -1., 2.)};
}

Json row(const std::string& name, double analyse, double factorise, double solve, double entries, double residual) {
  return {{"name", name},   {"analyse", analyse}, {"factorise", factorise},
          {"solve", solve}, {"entries", entries}, {"residual", residual}};
}

Json ours(const Problem& p) {
  std::unique_ptr<detail::Ldlt> ldlt;
  const Vector ones = Vector::Ones(p.b.size());
  const double analyse = once([&] { ldlt = std::make_unique<detail::Ldlt>(p.A); });
  ldlt->factorise(p.A, ones);
  const double factorise = median_time([&] { ldlt->factorise(p.A, ones); });
  Vector x(p.b.size());
  Stream memory(std::size_t{32} << 20), factor(static_cast<std::size_t>(ldlt->n_factor_entries()));
  // by turns, so that other load on the machine affects all alike
  std::vector<double> solve, read_memory, read_factor;
  for (int turn = 0; turn < 7; ++turn) {
    solve.push_back(median_time([&] { ldlt->solve(p.b, x); }));
    read_factor.push_back(median_time([&] { factor.read(); }));
    read_memory.push_back(median_time([&] { memory.read(); }));
  }
  Json json =
      row("upbead", analyse, factorise, median(solve), static_cast<double>(ldlt->n_factor_entries()), residual(p, x));
  json["bandwidth_memory"] = memory.bytes() / median(read_memory);
  json["bandwidth_factor"] = factor.bytes() / median(read_factor);
  Eigen::MatrixXd B = p.b.replicate(1, 8), X = B;
  json["solve_8_columns"] = median_time([&] { ldlt->solve(B, X); });
  return json;
}

/// The whole path of a solve, cell blocks included.
Json whole(const SparseMatrix& E, const std::vector<IndexRange>& blocks) {
  std::unique_ptr<Factorisation> factors;
  const double first = once([&] { factors = std::make_unique<Factorisation>(E, blocks); });
  const double again = median_time([&] { factors->refactor(E); });
  const Vector b = Vector::LinSpaced(E.rows(), -1., 2.);
  Vector x(b.size());
  return {{"construct", first}, {"refactor", again}, {"solve", median_time([&] { factors->solve(b, x); })}};
}

Json petsc(const Problem& p, const std::string& name, MatSolverType type, MatOrderingType ordering) {
  SparseMatrix A = p.A;
  const int n = static_cast<int>(A.rows());
  Mat matrix = nullptr, factor = nullptr;
  Vec b = nullptr, x = nullptr;
  IS rows = nullptr, columns = nullptr;
  Vector solution(n);
  MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr(), &matrix);
  MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE);
  VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, p.b.data(), &b);
  VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, solution.data(), &x);
  MatFactorInfo options;
  MatFactorInfoInitialize(&options);
  options.fill = 5.;
  const double analyse = once([&] {
    MatGetOrdering(matrix, ordering, &rows, &columns);
    MatGetFactor(matrix, type, MAT_FACTOR_CHOLESKY, &factor);
    MatCholeskyFactorSymbolic(factor, matrix, rows, &options);
  });
  const double factorise = once([&] { MatCholeskyFactorNumeric(factor, matrix, &options); });
  const double solve = median_time([&] { MatSolve(factor, b, x); });
  MatInfo info;
  MatGetInfo(factor, MAT_LOCAL, &info);
  Json json = row(name, analyse, factorise, solve, info.nz_used, residual(p, solution));
  MatDestroy(&factor);
  MatDestroy(&matrix);
  VecDestroy(&b);
  VecDestroy(&x);
  ISDestroy(&rows);
  ISDestroy(&columns);
  return json;
}

Json cholmod(const Problem& p) {
  SparseMatrix A = p.A;
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SIMPLICIAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_AMD;
  const auto n = static_cast<std::size_t>(A.rows());
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = n;
  matrix.nzmax = static_cast<std::size_t>(A.nonZeros());
  matrix.p = A.outerIndexPtr();
  matrix.i = A.innerIndexPtr();
  matrix.x = A.valuePtr();
  matrix.stype = 1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_REAL;
  matrix.sorted = matrix.packed = 1;
  cholmod_factor* factor = nullptr;
  const double analyse = once([&] { factor = cholmod_analyze(&matrix, &common); });
  const double factorise = once([&] { cholmod_factorize(&matrix, factor, &common); });
  Vector rhs = p.b, solution(p.b.size());
  cholmod_dense b{n, 1, n, n, rhs.data(), nullptr, CHOLMOD_REAL, CHOLMOD_DOUBLE};
  cholmod_dense *x = nullptr, *work = nullptr, *more = nullptr;
  const double solve =
      median_time([&] { cholmod_solve2(CHOLMOD_A, factor, &b, nullptr, &x, nullptr, &work, &more, &common); });
  solution = Eigen::Map<const Vector>(static_cast<const double*>(x->x), static_cast<Eigen::Index>(n));
  Json json = row("CHOLMOD, simplicial", analyse, factorise, solve, common.lnz, residual(p, solution));
  for (cholmod_dense** dense : {&x, &work, &more}) cholmod_free_dense(dense, &common);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return json;
}

Json measure(const Simulation& scene) {
  const System& system = scene.system();
  const SparseMatrix E = effective_matrix(system, 0.0025);
  const Problem p = condensed(E, system.blocks);
  Json json{{"unknowns", system.n_free()}, {"condensed", p.A.rows()}, {"entries_of_matrix", p.A.nonZeros()}};
  json["solvers"] = {ours(p), petsc(p, "PETSc, minimum degree", MATSOLVERPETSC, MATORDERINGAMD),
                     petsc(p, "PETSc, nested dissection", MATSOLVERPETSC, MATORDERINGND), cholmod(p),
                     petsc(p, "MUMPS", MATSOLVERMUMPS, MATORDERINGEXTERNAL)};
  json["whole"] = whole(E, system.blocks);
  return json;
}

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::invalid_argument("usage: bench_solves CASE [KEY=VALUE]...");
    const upbead::PetscSession petsc;
    const upbead::Simulation scene =
        upbead::simulation_of(upbead::read_case(argv[1], std::vector<std::string>(argv + 2, argv + argc)));
    std::cout << upbead::measure(scene).dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
