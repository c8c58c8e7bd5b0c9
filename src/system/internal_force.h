// What soil that yields adds to a system: M x'' + C x' + K x = sum_k b_k f_k(t) + p(x, history).
#pragma once

#include <stdexcept>
#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// The force p that corrects the elastic K x, and what it remembers. p is zero as long as nothing has yielded.
class InternalForce {
 public:
  virtual ~InternalForce() = default;

  /// Rows of the system in which p may be other than zero, ascending.
  virtual const std::vector<int>& rows() const = 0;
  /// p at x in these rows, from the committed history: what was evaluated since does not count.
  virtual void evaluate(const Vector& x, Vector& p) = 0;
  /// x becomes history. Returns the energy that was dissipated since the last commit (J/m, not negative).
  virtual double commit(const Vector& x) = 0;
  /// What it adds to each reading of the system at the committed x, which K x does not hold.
  virtual const Vector& added_to_readings() const = 0;
  /// Norm of all that the soil exerts in its rows, K x - p, at the committed x: what p is to be exact for.
  virtual double exerted() const = 0;
  /// Energy that is stored, less that of the elastic K, at the committed x (J/m). The work of p since rest is -(this +
  /// what was dissipated), but for what the steps take.
  virtual double stored_beside_elastic() const = 0;
  /// All that it has committed, for checkpoints, and back.
  virtual std::vector<double> memory() const { throw std::invalid_argument(no_memory); }
  virtual void recall(const std::vector<double>& /*memory*/) { throw std::invalid_argument(no_memory); }

 private:
  static constexpr const char* no_memory = "this internal force keeps no checkpoints";
};

}  // namespace upbead
