// Responses of a march to hat functions: their sum is the march, with its errors of steps, under every load that is
// straight within the steps.
#pragma once

#include <vector>

#include "upbead/dynamics/scheme.h"

namespace upbead {

/// Responses, I readings x (N + 1) times j step, to the halves of a hat of height 1 and width 2 step at t = 0. A scheme
/// with a constant step does the same in every step, so that loads f which may jump at t_n, from before(n) to after(n),
/// give y_j = sum_n before(n) left_(j-n) + after(n) right_(j-n).
struct Kernel {
  double step = 0.;       ///< s
  Eigen::MatrixXd left;   ///< the half that rises to t = 0 and there drops to zero; read at t = 0 before it drops
  Eigen::MatrixXd right;  ///< the half that jumps to 1 at t = 0 and falls; zero at t = 0, where no load counts yet
  bool jumps = true;      ///< false: of loads without jumps only; `left` is the whole hat's and `right` zero
};

/// Kernel of load k of a System in `n_steps` steps of `step` (s), by one or two marches; the histories of the
/// system's loads do not matter. Readings by their indices, at the ends of the steps (where generalised-alpha does
/// not satisfy the equation of motion).
///
/// SDIRK: equal to a march for all loads, up to round-off. Generalised-alpha: for forces without jumps, at t = 0
/// neither. At a jump, and at each kink of a prescribed velocity, it takes three tiny steps that compute x'' anew for
/// the whole state, whatever load moves it, and that take the loads a millionth of a step late. So their effect
/// depends on all jumps and kinks, and a sum of responses lacks it: errors of some 1e-5 in x and 1e-2 in x''. Throws
/// std::invalid_argument for a prescribed velocity with that scheme, std::out_of_range where there is no such load or
/// reading.
Kernel discrete_kernel(const System& system, const SchemeOptions& options, int k, const std::vector<int>& readings,
                       double step, int n_steps);

/// Readings x times for a load sampled at the kernel's N + 1 times, before(0) being ignored, as a march begins without
/// load. By FFT, padded by zeros. Throws std::invalid_argument where the samples are not N + 1, or jump where the
/// kernel does not.
Eigen::MatrixXd convolve(const Kernel& kernel, const Eigen::VectorXd& before, const Eigen::VectorXd& after);

/// The same for a load that jumps at t = 0 at most.
Eigen::MatrixXd convolve(const Kernel& kernel, const Eigen::VectorXd& samples);

}  // namespace upbead
