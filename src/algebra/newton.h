// r(x) = 0 for functions whose derivative is known.
#pragma once

#include <functional>
#include <memory>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// What a solution took.
struct NewtonReport {
  int iterations = 0;    ///< each with one factorisation
  double residual = 0.;  ///< |r| at the end
  bool converged = false;
};

/// How long a step is: whole; cut until |r| falls (backtracking); or, where r is the slope of a convex function, as
/// long as it takes to come near the least value along the step, also longer than whole. |r| may grow on that way.
enum class StepLength { whole, by_residual, by_potential };

/// Newton's method by PETSc's SNES, each linear system by an unsymmetric direct factorisation (MUMPS). Keeps its
/// vectors and the ordering from solution to solution. One thread at a time, while a PetscSession lives.
class Newton {
 public:
  /// r at x, and its derivative where r was asked for last: values in the order of the pattern.
  using Residual = std::function<void(const Vector& x, Vector& r)>;
  using Derivative = std::function<void(Eigen::Ref<Vector> values)>;

  /// `pattern`: compressed, its values do not count. `most`: iterations after which a solution gives up.
  Newton(SparseMatrix pattern, Residual residual, Derivative derivative, int most = 30,
         StepLength length = StepLength::by_residual);
  ~Newton();
  Newton(Newton&&) noexcept;

  /// From the x that is given until |r| <= tolerance. Not converged where it gave up, no step lessens |r|, the
  /// derivative is singular, or r is not finite. Throws what the functions throw; NumericsError where PETSc fails
  /// otherwise.
  NewtonReport solve(Vector& x, double tolerance);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace upbead
