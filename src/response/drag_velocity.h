// The velocity of the pore water at which a drag that grows with it is made linear.
#pragma once

#include <vector>

#include "fem/unknowns.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// In the middle of each cell of a region with `forchheimer`, over a march: the integral of |w|^3 over that of |w|^2,
/// at which linear drag b w_c w takes as much energy as b |w| w (Lorentz 1926): |w| of steady flow, 8/(3 pi) of the
/// amplitude where it swings.
class DragVelocity : public MarchObserver {
 public:
  DragVelocity(const Space& space, const Unknowns& unknowns);
  void see(const State& state, int step, int n_steps) override;
  /// By active cell index (m/s); 0 where no drag grows.
  std::vector<double> found() const;

 private:
  std::vector<std::size_t> cells_;
  std::size_t n_active_;
  SparseMatrix along_x_, along_y_;  ///< of w over the rates of the unknowns
  Eigen::ArrayXd last_, square_, cube_;
  double time_ = 0.;
};

}  // namespace upbead
