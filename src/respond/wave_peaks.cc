#include "wave_peaks.h"

#include <cmath>

namespace upbead {

namespace {

struct Peak {
  double time = 0., value = 0.;
};

/// The largest sample. Where `smooth` and its neighbours are equally far, the top of the parabola through the three.
Peak largest(const std::vector<double>& time, const Eigen::RowVectorXd& y, bool smooth) {
  Eigen::Index n = 0;
  const double top = y.maxCoeff(&n);
  const auto at = static_cast<std::size_t>(n);
  if (!smooth || n == 0 || n + 1 == y.size()) return {time[at], top};
  const double before = time[at] - time[at - 1], after = time[at + 1] - time[at];
  if (std::abs(after - before) > 1e-6 * before) return {time[at], top};
  const double slope = (y[n + 1] - y[n - 1]) / 2., bend = y[n + 1] - 2. * top + y[n - 1];
  if (!(bend < 0.)) return {time[at], top};
  const double aside = -slope / bend;  // in steps, between -1/2 and 1/2
  return {time[at] + aside * after, top + 0.5 * aside * slope};
}

}  // namespace

void set_peaks(const std::vector<double>& time, const Eigen::RowVectorXd& P, const Eigen::RowVectorXd& F, bool smooth,
               WaveResponse& out) {
  const Peak landward = largest(time, F, smooth);
  out.peak_force = P.maxCoeff();
  out.peak_shear = landward.value;
  out.peak_shear_time = landward.time;
  out.peak_shear_seaward = -largest(time, -F, smooth).value;
  const double P_seaward = P.minCoeff();
  const bool seaward = -P_seaward > out.peak_force;
  const double force = seaward ? P_seaward : out.peak_force;
  if (force != 0.) out.ratio = (seaward ? out.peak_shear_seaward : out.peak_shear) / force;
}

}  // namespace upbead
