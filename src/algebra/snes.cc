#include "algebra/snes.h"

#include <string>

#include "upbead/base/error.h"

namespace upbead {

void check_snes(PetscErrorCode error) {
  if (error != 0) throw NumericsError("PETSc's non-linear solver failed (its error " + std::to_string(error) + ")");
}

PetscErrorCode copy(Vec from, Vector& to) {
  const double* values = nullptr;
  const PetscErrorCode error = VecGetArrayRead(from, &values);
  if (error != 0) return error;
  to = Eigen::Map<const Vector>(values, to.size());
  return VecRestoreArrayRead(from, &values);
}

PetscErrorCode copy(const Vector& from, Vec to) {
  double* values = nullptr;
  const PetscErrorCode error = VecGetArrayWrite(to, &values);
  if (error != 0) return error;
  Eigen::Map<Vector>(values, from.size()) = from;
  return VecRestoreArrayWrite(to, &values);
}

SnesReport solve_snes(SNES snes, Vec at, Vector& x, double tolerance, std::exception_ptr& thrown) {
  thrown = nullptr;
  PetscReal relative, step;
  PetscInt most, most_evaluations;
  check_snes(SNESGetTolerances(snes, nullptr, &relative, &step, &most, &most_evaluations));
  check_snes(SNESSetTolerances(snes, tolerance, relative, step, most, most_evaluations));
  check_snes(copy(x, at));
  const PetscErrorCode error = SNESSolve(snes, nullptr, at);
  if (thrown) std::rethrow_exception(thrown);
  check_snes(error);
  SNESConvergedReason reason;
  check_snes(SNESGetConvergedReason(snes, &reason));
  SnesReport report;
  report.converged = reason > 0;
  check_snes(SNESGetFunctionNorm(snes, &report.residual));
  check_snes(copy(at, x));
  return report;
}

}  // namespace upbead
