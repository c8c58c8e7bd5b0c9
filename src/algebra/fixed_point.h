// Solves q = map(q) for maps that are costly to evaluate and whose derivative is unknown.
#pragma once

#include <functional>
#include <memory>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// Effort and result of a solution.
struct FixedPointReport {
  int evaluations = 0;   ///< of the map
  double residual = 0.;  ///< |map(q) - q| at the end
  bool converged = false;
};

/// Anderson mixing (Anderson, J. ACM 12 (1965) 547) by PETSc's SNES, with the last five iterates. Keeps its vectors
/// for the next solution. One thread at a time, while a PetscSession lives.
class FixedPoint {
 public:
  using Map = std::function<void(const Vector& q, Vector& value)>;

  /// `most`: evaluations of the map, after which a solution gives up.
  FixedPoint(int size, Map map, int most = 60);
  ~FixedPoint();
  FixedPoint(FixedPoint&&) noexcept;

  /// Iterates from the given q until |map(q) - q| <= tolerance. Not converged after `most` evaluations, or where the
  /// map is not finite. Throws what the map throws; NumericsError where PETSc fails otherwise.
  FixedPointReport solve(Vector& q, double tolerance);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace upbead
