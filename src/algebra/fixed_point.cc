#include "algebra/fixed_point.h"

#include <exception>
#include <string>
#include <utility>

#include "algebra/snes.h"

namespace upbead {

namespace {

constexpr const char* prefix = "upbead_fixed_point_";  // of this solver's options in PETSc's table

}  // namespace

struct FixedPoint::Solver {
  SNES snes = nullptr;
  Vec at = nullptr, residual = nullptr;
  Map map;
  Vector q, value;
  int evaluations = 0;
  std::exception_ptr thrown;  ///< exception of the map, which PETSc calls

  Solver(int size, Map given, int most);
  ~Solver() {
    VecDestroy(&at);
    VecDestroy(&residual);
    SNESDestroy(&snes);
  }
  static PetscErrorCode evaluate(SNES, Vec x, Vec f, void* context);
};

FixedPoint::Solver::Solver(int size, Map given, int most) : map(std::move(given)), q(size), value(size) {
  check_snes(PetscOptionsSetValue(nullptr, ("-" + std::string(prefix) + "snes_anderson_m").c_str(), "5"));
  check_snes(SNESCreate(PETSC_COMM_SELF, &snes));
  check_snes(VecCreateSeq(PETSC_COMM_SELF, size, &at));
  check_snes(VecDuplicate(at, &residual));
  check_snes(SNESSetType(snes, SNESANDERSON));
  check_snes(SNESSetOptionsPrefix(snes, prefix));
  check_snes(SNESSetFunction(snes, residual, evaluate, this));
  check_snes(SNESSetFromOptions(snes));
  check_snes(SNESSetTolerances(snes, 0., 0., 0., most, most));
}

/// F(q) = q - map(q). An exception of the map must not pass through PETSc: it is kept.
PetscErrorCode FixedPoint::Solver::evaluate(SNES snes, Vec x, Vec f, void* context) {
  Solver& self = *static_cast<Solver*>(context);
  if (const PetscErrorCode error = copy(x, self.q); error != 0) return error;
  try {
    ++self.evaluations;
    self.map(self.q, self.value);
  } catch (...) {
    self.thrown = std::current_exception();
    return SNESSetFunctionDomainError(snes);
  }
  self.q -= self.value;
  return copy(self.q, f);
}

FixedPoint::FixedPoint(int size, Map map, int most) : solver_(std::make_unique<Solver>(size, std::move(map), most)) {}
FixedPoint::~FixedPoint() = default;
FixedPoint::FixedPoint(FixedPoint&&) noexcept = default;

FixedPointReport FixedPoint::solve(Vector& q, double tolerance) {
  Solver& s = *solver_;
  s.evaluations = 0;
  const SnesReport found = solve_snes(s.snes, s.at, q, tolerance, s.thrown);
  return {s.evaluations, found.residual, found.converged};
}

}  // namespace upbead
