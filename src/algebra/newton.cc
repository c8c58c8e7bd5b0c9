#include "algebra/newton.h"

#include <petscsnes.h>

#include <exception>
#include <string>
#include <utility>

#include "upbead/base/error.h"

namespace upbead {

namespace {

void check_newton(PetscErrorCode error) {
  if (error != 0) throw NumericsError("PETSc's Newton solver failed (its error " + std::to_string(error) + ")");
}

}  // namespace

struct Newton::Solver {
  SNES snes = nullptr;
  Vec at = nullptr, residual = nullptr;
  Mat matrix = nullptr;  // stands on the arrays of J
  SparseMatrix J;
  Residual r;
  Derivative derivative;
  Vector x, value;
  std::exception_ptr thrown;  ///< by the functions, which PETSc calls

  Solver(SparseMatrix pattern, Residual given_r, Derivative given_derivative, int most, bool search);
  ~Solver() {
    VecDestroy(&at);
    VecDestroy(&residual);
    MatDestroy(&matrix);
    SNESDestroy(&snes);
  }
  void choose_methods(int most, bool search);
  PetscErrorCode read(Vec from);
  static PetscErrorCode evaluate(SNES, Vec x, Vec f, void* context);
  static PetscErrorCode differentiate(SNES, Vec x, Mat, Mat, void* context);
};

Newton::Solver::Solver(SparseMatrix pattern, Residual given_r, Derivative given_derivative, int most, bool search)
    : J(std::move(pattern)), r(std::move(given_r)), derivative(std::move(given_derivative)) {
  const auto size = static_cast<PetscInt>(J.rows());
  x = value = Vector::Zero(size);
  check_newton(SNESCreate(PETSC_COMM_SELF, &snes));
  check_newton(VecCreateSeq(PETSC_COMM_SELF, size, &at));
  check_newton(VecDuplicate(at, &residual));
  check_newton(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, size, size, J.outerIndexPtr(), J.innerIndexPtr(),
                                         J.valuePtr(), &matrix));
  check_newton(SNESSetFunction(snes, residual, evaluate, this));
  check_newton(SNESSetJacobian(snes, matrix, matrix, differentiate, this));
  choose_methods(most, search);
}

void Newton::Solver::choose_methods(int most, bool search) {
  check_newton(SNESSetType(snes, SNESNEWTONLS));
  SNESLineSearch line_search = nullptr;
  check_newton(SNESGetLineSearch(snes, &line_search));
  check_newton(SNESLineSearchSetType(line_search, search ? SNESLINESEARCHBT : SNESLINESEARCHBASIC));
  KSP ksp = nullptr;
  PC pc = nullptr;
  check_newton(SNESGetKSP(snes, &ksp));
  check_newton(KSPSetType(ksp, KSPPREONLY));
  check_newton(KSPGetPC(ksp, &pc));
  check_newton(PCSetType(pc, PCLU));
  check_newton(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  check_newton(SNESSetTolerances(snes, 0., 0., 0., most, 50 * most));
}

PetscErrorCode Newton::Solver::read(Vec from) {
  const double* values = nullptr;
  const PetscErrorCode error = VecGetArrayRead(from, &values);
  if (error != 0) return error;
  x = Eigen::Map<const Vector>(values, x.size());
  return VecRestoreArrayRead(from, &values);
}

/// What the functions throw may not pass through PETSc, and is kept.
PetscErrorCode Newton::Solver::evaluate(SNES snes, Vec at, Vec f, void* context) {
  Solver& self = *static_cast<Solver*>(context);
  PetscErrorCode error = self.read(at);
  if (error != 0) return error;
  try {
    self.r(self.x, self.value);
  } catch (...) {
    self.thrown = std::current_exception();
  }
  if (self.thrown || !self.value.allFinite()) return SNESSetFunctionDomainError(snes);
  double* to = nullptr;
  error = VecGetArrayWrite(f, &to);
  if (error != 0) return error;
  Eigen::Map<Vector>(to, self.value.size()) = self.value;
  return VecRestoreArrayWrite(f, &to);
}

/// The residual was asked for last where the derivative is, unless the line search went on from there.
PetscErrorCode Newton::Solver::differentiate(SNES snes, Vec at, Mat matrix, Mat, void* context) {
  Solver& self = *static_cast<Solver*>(context);
  const Vector last = self.x;
  PetscErrorCode error = self.read(at);
  if (error != 0) return error;
  double* values = nullptr;
  error = MatSeqAIJGetArray(matrix, &values);
  if (error != 0) return error;
  try {
    if (self.x != last) self.r(self.x, self.value);
    self.derivative(Eigen::Map<Vector>(values, self.J.nonZeros()));
  } catch (...) {
    self.thrown = std::current_exception();
  }
  error = MatSeqAIJRestoreArray(matrix, &values);
  return error != 0 || !self.thrown ? error : SNESSetJacobianDomainError(snes);
}

Newton::Newton(SparseMatrix pattern, Residual residual, Derivative derivative, int most, bool search)
    : solver_(std::make_unique<Solver>(std::move(pattern), std::move(residual), std::move(derivative), most, search)) {}
Newton::~Newton() = default;
Newton::Newton(Newton&&) noexcept = default;

NewtonReport Newton::solve(Vector& x, double tolerance) {
  Solver& s = *solver_;
  s.thrown = nullptr;
  PetscReal relative, step;
  PetscInt most, most_evaluations;
  check_newton(SNESGetTolerances(s.snes, nullptr, &relative, &step, &most, &most_evaluations));
  check_newton(SNESSetTolerances(s.snes, tolerance, relative, step, most, most_evaluations));
  double* values = nullptr;
  check_newton(VecGetArray(s.at, &values));
  Eigen::Map<Vector>(values, x.size()) = x;
  check_newton(VecRestoreArray(s.at, &values));
  const PetscErrorCode error = SNESSolve(s.snes, nullptr, s.at);
  if (s.thrown) std::rethrow_exception(s.thrown);
  check_newton(error);
  SNESConvergedReason reason;
  check_newton(SNESGetConvergedReason(s.snes, &reason));
  NewtonReport report;
  report.converged = reason > 0;
  PetscInt iterations = 0;
  check_newton(SNESGetIterationNumber(s.snes, &iterations));
  report.iterations = static_cast<int>(iterations);
  check_newton(SNESGetFunctionNorm(s.snes, &report.residual));
  check_newton(VecGetArray(s.at, &values));
  x = Eigen::Map<Vector>(values, x.size());
  check_newton(VecRestoreArray(s.at, &values));
  return report;
}

}  // namespace upbead
