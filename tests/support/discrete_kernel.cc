#include "discrete_kernel.h"

#include <stdexcept>

#include "dynamics/real_fft.h"
#include "upbead/dynamics/march.h"

namespace upbead {

namespace {

double zero(double) {
  return 0.;
}

/// From 1 at t = 0 to 0 at t = h.
TimeFunction right_half(double h) {
  return TimeFunction({0., h}, {zero, [h](double t) { return 1. - t / h; }, zero});
}

/// From 0 at t = 0 over 1 at t = h to 0 at t = 2 h.
TimeFunction hat(double h) {
  return TimeFunction({0., h, 2. * h},
                      {zero, [h](double t) { return t / h; }, [h](double t) { return 2. - t / h; }, zero});
}

/// The system with the readings of these indices alone and without loads.
System unloaded(const System& system, const std::vector<int>& readings) {
  System copy = system;
  copy.readings.clear();
  for (const int i : readings) copy.readings.push_back(system.readings.at(i));
  for (SystemLoad& load : copy.loads) load.history = TimeFunction();
  return copy;
}

Eigen::MatrixXd marched(const System& system, const SchemeOptions& options, double step, int n_steps) {
  const TimeGrid grid{{{0., step, n_steps}}, n_steps * step};
  return march(system, *make_scheme(system, options), grid).ends.reading;
}

}  // namespace

Kernel discrete_kernel(const System& system, const SchemeOptions& options, int k, const std::vector<int>& readings,
                       double step, int n_steps) {
  const bool jumps = options.kind != SchemeKind::generalised_alpha;
  if (system.loads.at(k).prescribed >= 0 && !jumps)
    throw std::invalid_argument("generalised-alpha has no kernel for a prescribed velocity");
  SchemeOptions lean = options;
  lean.account_energy = false;
  System loaded = unloaded(system, readings);
  loaded.loads[k].history = hat(step);
  const Eigen::MatrixXd whole = marched(loaded, lean, step, n_steps + 1).rightCols(n_steps + 1);
  if (!jumps) return {step, whole, Eigen::MatrixXd::Zero(whole.rows(), whole.cols()), jumps};
  loaded.loads[k].history = right_half(step);
  const Eigen::MatrixXd right = marched(loaded, lean, step, n_steps);
  return {step, whole - right, right, jumps};
}

Eigen::MatrixXd convolve(const Kernel& kernel, const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
  const Eigen::Index n = kernel.right.cols();
  if (before.size() != n || after.size() != n)
    throw std::invalid_argument("the samples of a load do not fit the times of the kernel");
  Eigen::VectorXd counted = before;
  counted[0] = 0.;
  if (!kernel.jumps && counted != after)
    throw std::invalid_argument("a kernel of loads that do not jump, but one does");
  const detail::RealFft fft(2 * n);
  const Eigen::VectorXcd of_left = fft.forward(counted), of_right = fft.forward(after);
  Eigen::MatrixXd y(kernel.right.rows(), n);
  for (Eigen::Index i = 0; i < y.rows(); ++i) {
    const Eigen::VectorXcd left = fft.forward(kernel.left.row(i).transpose()),
                           right = fft.forward(kernel.right.row(i).transpose());
    y.row(i) = fft.backward(left.cwiseProduct(of_left) + right.cwiseProduct(of_right)).head(n).transpose();
  }
  return y;
}

Eigen::MatrixXd convolve(const Kernel& kernel, const Eigen::VectorXd& samples) {
  return convolve(kernel, samples, samples);
}

}  // namespace upbead
