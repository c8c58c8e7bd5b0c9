// Solves r(x) = 0 for functions whose derivative is known.
#pragma once

#include <functional>
#include <memory>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// Effort and result of a solution.
struct NewtonReport {
  int iterations = 0;    ///< each with one factorisation
  double residual = 0.;  ///< |r| at the end
  bool converged = false;
};

/// Length of a step: whole; cut until |r| falls (backtracking); or, where r is the gradient of a convex function, the
/// length that comes near the least value along the step, which may be more than whole. |r| may grow then.
enum class StepLength { whole, by_residual, by_potential };

/// Newton's method by PETSc's SNES, each linear system by an unsymmetric direct factorisation (MUMPS). Keeps its
/// vectors and the ordering for the next solution. One thread at a time, while a PetscSession lives.
class Newton {
 public:
  /// r at x; and the derivative at the x of the last call of r: values in the order of the pattern.
  using Residual = std::function<void(const Vector& x, Vector& r)>;
  using Derivative = std::function<void(Eigen::Ref<Vector> values)>;

  /// `pattern`: compressed, its values are ignored. `most`: iterations after which a solution gives up.
  Newton(SparseMatrix pattern, Residual residual, Derivative derivative, int most = 30,
         StepLength length = StepLength::by_residual);
  ~Newton();
  Newton(Newton&&) noexcept;

  /// Iterates from the given x until |r| <= tolerance. Not converged after `most` iterations, or where no step
  /// reduces |r|, the derivative is singular, or r is not finite. Throws what the functions throw; NumericsError
  /// where PETSc fails otherwise.
  NewtonReport solve(Vector& x, double tolerance);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace upbead
