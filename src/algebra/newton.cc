#include "algebra/newton.h"

#include <exception>
#include <utility>

#include "algebra/snes.h"
#include "algebra/step_length.h"

namespace upbead {

struct Newton::Solver {
  SNES snes = nullptr;
  Vec at = nullptr, residual = nullptr;
  Mat matrix = nullptr;  // uses the arrays of J
  SparseMatrix J;
  Residual r;
  Derivative derivative;
  Vector x, value;
  std::exception_ptr thrown;  ///< exception of the functions, which PETSc calls

  Solver(SparseMatrix pattern, Residual given_r, Derivative given_derivative, int most, StepLength length);
  ~Solver() {
    VecDestroy(&at);
    VecDestroy(&residual);
    MatDestroy(&matrix);
    SNESDestroy(&snes);
  }
  void choose_methods(int most, StepLength length);
  static PetscErrorCode evaluate(SNES, Vec x, Vec f, void* context);
  static PetscErrorCode differentiate(SNES, Vec x, Mat, Mat, void* context);
};

Newton::Solver::Solver(SparseMatrix pattern, Residual given_r, Derivative given_derivative, int most, StepLength length)
    : J(std::move(pattern)), r(std::move(given_r)), derivative(std::move(given_derivative)) {
  const auto size = static_cast<PetscInt>(J.rows());
  x = value = Vector::Zero(size);
  check_snes(SNESCreate(PETSC_COMM_SELF, &snes));
  check_snes(VecCreateSeq(PETSC_COMM_SELF, size, &at));
  check_snes(VecDuplicate(at, &residual));
  check_snes(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, size, size, J.outerIndexPtr(), J.innerIndexPtr(), J.valuePtr(),
                                       &matrix));
  check_snes(SNESSetFunction(snes, residual, evaluate, this));
  check_snes(SNESSetJacobian(snes, matrix, matrix, differentiate, this));
  choose_methods(most, length);
}

void Newton::Solver::choose_methods(int most, StepLength length) {
  check_snes(SNESSetType(snes, SNESNEWTONLS));
  SNESLineSearch line_search = nullptr;
  check_snes(SNESGetLineSearch(snes, &line_search));
  const bool by_potential = length == StepLength::by_potential;
  check_snes(SNESLineSearchSetType(line_search, by_potential                        ? SNESLINESEARCHSHELL
                                                : length == StepLength::by_residual ? SNESLINESEARCHBT
                                                                                    : SNESLINESEARCHBASIC));
  if (by_potential) check_snes(SNESLineSearchShellSetUserFunc(line_search, step_to_least, nullptr));
  KSP ksp = nullptr;
  PC pc = nullptr;
  check_snes(SNESGetKSP(snes, &ksp));
  check_snes(KSPSetType(ksp, KSPPREONLY));
  check_snes(KSPGetPC(ksp, &pc));
  check_snes(PCSetType(pc, PCLU));
  check_snes(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  check_snes(SNESSetTolerances(snes, 0., 0., 0., most, 50 * most));
}

/// An exception of the functions must not pass through PETSc: it is kept.
PetscErrorCode Newton::Solver::evaluate(SNES snes, Vec at, Vec f, void* context) {
  Solver& self = *static_cast<Solver*>(context);
  if (const PetscErrorCode error = copy(at, self.x); error != 0) return error;
  try {
    self.r(self.x, self.value);
  } catch (...) {
    self.thrown = std::current_exception();
  }
  if (self.thrown || !self.value.allFinite()) return SNESSetFunctionDomainError(snes);
  return copy(self.value, f);
}

/// The residual is evaluated anew only if its last evaluation, in the line search, was at another point.
PetscErrorCode Newton::Solver::differentiate(SNES snes, Vec at, Mat matrix, Mat, void* context) {
  Solver& self = *static_cast<Solver*>(context);
  const Vector last = self.x;
  PetscErrorCode error = copy(at, self.x);
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

Newton::Newton(SparseMatrix pattern, Residual residual, Derivative derivative, int most, StepLength length)
    : solver_(std::make_unique<Solver>(std::move(pattern), std::move(residual), std::move(derivative), most, length)) {}
Newton::~Newton() = default;
Newton::Newton(Newton&&) noexcept = default;

NewtonReport Newton::solve(Vector& x, double tolerance) {
  Solver& s = *solver_;
  const SnesReport found = solve_snes(s.snes, s.at, x, tolerance, s.thrown);
  PetscInt iterations = 0;
  check_snes(SNESGetIterationNumber(s.snes, &iterations));
  return {static_cast<int>(iterations), found.residual, found.converged};
}

}  // namespace upbead
