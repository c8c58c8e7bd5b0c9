#include "respond_sliding.h"

#include <algorithm>

#include "upbead/sliding/block.h"

namespace upbead {

namespace {

/// Linear between the times, zero before the first.
double value_at(const std::vector<double>& time, const Eigen::RowVectorXd& values, double t) {
  const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
  if (next == 0) return 0.;
  if (next == static_cast<std::ptrdiff_t>(time.size())) return values[values.size() - 1];
  const auto i = static_cast<std::size_t>(next);
  const double part = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return (1. - part) * values[next - 1] + part * values[next];
}

}  // namespace

Eigen::RowVectorXd uplift_of_force(const ModelSliding& sliding, const std::vector<double>& time,
                                   const Eigen::RowVectorXd& P) {
  Eigen::Index largest = 0;
  const double peak = std::max(P.maxCoeff(&largest), 0.);
  const double peak_time = time[static_cast<std::size_t>(largest)];
  Eigen::RowVectorXd U(P.size());
  for (Eigen::Index i = 0; i < P.size(); ++i) {
    const double t = time[static_cast<std::size_t>(i)] - sliding.lag;
    const double then = sliding.lag > 0. ? value_at(time, P, t) : P[i];
    const bool over = sliding.uplift == "held" && t > peak_time;
    U[i] = sliding.uplift_per_force * (over ? peak : std::max(then, 0.));
  }
  return U;
}

double sliding_distance(const ModelSliding& sliding, double mass, const std::vector<double>& time,
                        const Eigen::RowVectorXd& F_T, const Eigen::RowVectorXd& U) {
  Eigen::RowVectorXd R = Eigen::RowVectorXd::Constant(F_T.size(), sliding.buoyant_weight);
  if (U.size() > 0) R = (R - U).cwiseMax(0.);
  R *= sliding.friction;
  // it rests until F_T first exceeds R; to leave that time out spares most waves the work
  Eigen::Index start = 0;
  while (start < F_T.size() && std::abs(F_T[start]) <= R[start]) ++start;
  if (start == F_T.size()) return 0.;
  const auto rest = std::max<Eigen::Index>(start - 1, 0);
  const std::vector<double> left(time.begin() + rest, time.end());
  ForceHistory resistance{left, {R.begin() + rest, R.end()}};
  resistance.time.push_back(left.back());
  resistance.value.push_back(sliding.friction * sliding.buoyant_weight);  // the wave is over
  return slide(mass, {left, {F_T.begin() + rest, F_T.end()}}, resistance, sliding.drag).residual;
}

}  // namespace upbead
