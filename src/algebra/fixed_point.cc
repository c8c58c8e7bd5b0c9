#include "algebra/fixed_point.h"

#include <petscsnes.h>

#include <exception>
#include <string>
#include <utility>

#include "upbead/base/error.h"

namespace upbead {

namespace {

void check(PetscErrorCode error) {
  if (error != 0) throw NumericsError("PETSc's non-linear solver failed (its error " + std::to_string(error) + ")");
}

constexpr const char* prefix = "upbead_fixed_point_";  // of its options in PETSc's table

}  // namespace

struct FixedPoint::Solver {
  SNES snes = nullptr;
  Vec at = nullptr, residual = nullptr;
  Map map;
  Vector q, value;
  int evaluations = 0;
  std::exception_ptr thrown;  ///< by the map, which PETSc calls

  Solver(int size, Map given, int most);
  ~Solver() {
    VecDestroy(&at);
    VecDestroy(&residual);
    SNESDestroy(&snes);
  }
  static PetscErrorCode evaluate(SNES, Vec x, Vec f, void* context);
};

FixedPoint::Solver::Solver(int size, Map given, int most) : map(std::move(given)), q(size), value(size) {
  check(PetscOptionsSetValue(nullptr, ("-" + std::string(prefix) + "snes_anderson_m").c_str(), "5"));
  check(SNESCreate(PETSC_COMM_SELF, &snes));
  check(VecCreateSeq(PETSC_COMM_SELF, size, &at));
  check(VecDuplicate(at, &residual));
  check(SNESSetType(snes, SNESANDERSON));
  check(SNESSetOptionsPrefix(snes, prefix));
  check(SNESSetFunction(snes, residual, evaluate, this));
  check(SNESSetFromOptions(snes));
  check(SNESSetTolerances(snes, 0., 0., 0., most, most));
}

/// F(q) = q - map(q). What the map throws may not pass through PETSc, and is kept.
PetscErrorCode FixedPoint::Solver::evaluate(SNES snes, Vec x, Vec f, void* context) {
  Solver& self = *static_cast<Solver*>(context);
  const double* from = nullptr;
  PetscErrorCode error = VecGetArrayRead(x, &from);
  if (error != 0) return error;
  self.q = Eigen::Map<const Vector>(from, self.q.size());
  error = VecRestoreArrayRead(x, &from);
  if (error != 0) return error;
  try {
    ++self.evaluations;
    self.map(self.q, self.value);
  } catch (...) {
    self.thrown = std::current_exception();
    return SNESSetFunctionDomainError(snes);
  }
  double* to = nullptr;
  error = VecGetArrayWrite(f, &to);
  if (error != 0) return error;
  Eigen::Map<Vector>(to, self.q.size()) = self.q - self.value;
  return VecRestoreArrayWrite(f, &to);
}

FixedPoint::FixedPoint(int size, Map map, int most) : solver_(std::make_unique<Solver>(size, std::move(map), most)) {}
FixedPoint::~FixedPoint() = default;
FixedPoint::FixedPoint(FixedPoint&&) noexcept = default;

FixedPointReport FixedPoint::solve(Vector& q, double tolerance) {
  Solver& s = *solver_;
  s.evaluations = 0;
  s.thrown = nullptr;
  PetscReal relative, step;
  PetscInt most, most_evaluations;
  check(SNESGetTolerances(s.snes, nullptr, &relative, &step, &most, &most_evaluations));
  check(SNESSetTolerances(s.snes, tolerance, relative, step, most, most_evaluations));
  double* values = nullptr;
  check(VecGetArray(s.at, &values));
  Eigen::Map<Vector>(values, q.size()) = q;
  check(VecRestoreArray(s.at, &values));
  const PetscErrorCode error = SNESSolve(s.snes, nullptr, s.at);
  if (s.thrown) std::rethrow_exception(s.thrown);
  check(error);
  SNESConvergedReason reason;
  check(SNESGetConvergedReason(s.snes, &reason));
  FixedPointReport report{s.evaluations, 0., reason > 0};
  check(SNESGetFunctionNorm(s.snes, &report.residual));
  check(VecGetArray(s.at, &values));
  q = Eigen::Map<Vector>(values, q.size());
  check(VecRestoreArray(s.at, &values));
  return report;
}

}  // namespace upbead
