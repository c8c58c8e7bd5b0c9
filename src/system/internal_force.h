// The force that soil which yields adds to a system: M x'' + C x' + K x = sum_k b_k f_k(t) + p(x, history).
#pragma once

#include <stdexcept>
#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// The force p that corrects the elastic K x, and its history. p is zero as long as nothing has yielded. Where the
/// system is divided, p is that of the whole, the same on all processes, while energies and readings are parts.
class InternalForce {
 public:
  virtual ~InternalForce() = default;

  /// Rows of the system in which p may be other than zero, ascending; where it is divided, those of the whole system,
  /// -1 for each for which another process counts.
  virtual const std::vector<int>& rows() const = 0;
  /// p at x in these rows, from the committed history; earlier calls of evaluate() have no effect.
  virtual void evaluate(const Vector& x, Vector& p) = 0;
  /// Commits x to the history. Returns the energy that was dissipated since the last commit (J/m, not negative).
  virtual double commit(const Vector& x) = 0;
  /// For each reading of the system, the part at the committed x that its rows do not give.
  virtual const Vector& added_to_readings() const = 0;
  /// Norm of the soil's total force in its rows, K x - p, at the committed x: the scale of the error allowed in p.
  virtual double exerted() const = 0;
  /// Energy stored, less that of the elastic K, at the committed x (J/m). The work of p since rest is -(this + the
  /// energy dissipated), up to the error of the steps.
  virtual double stored_beside_elastic() const = 0;
  /// The committed history as numbers, for checkpoints; recall() restores it.
  virtual std::vector<double> memory() const { throw std::invalid_argument(no_memory); }
  virtual void recall(const std::vector<double>& /*memory*/) { throw std::invalid_argument(no_memory); }

 private:
  static constexpr const char* no_memory = "this internal force keeps no checkpoints";
};

}  // namespace upbead
