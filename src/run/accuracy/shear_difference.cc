#include "shear_difference.h"

#include <algorithm>
#include <cmath>

#include "fem/caisson_readings.h"

namespace upbead {

namespace {

double value_at(const ShearHistory& history, double t) {
  const std::vector<double>& time = history.time;
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  if (after == time.end()) return history.force[history.force.size() - 1];
  const auto i = after - time.begin();
  if (i == 0) return history.force[0];
  const double part = (t - time[static_cast<std::size_t>(i) - 1]) / (*after - time[static_cast<std::size_t>(i) - 1]);
  return (1. - part) * history.force[i - 1] + part * history.force[i];
}

double over(double difference, double scale) {
  return scale > 0. ? difference / scale : 0.;
}

}  // namespace

ShearHistory shear_history(const CompiledScene& compiled, const Response& response, bool inertia) {
  const ShearResponse read = read_shear_response(compiled, response, inertia);
  const bool seaward = -read.peak_force_seaward > read.peak_force;
  return {response.ends.time, response.ends.reading.row(compiled.system.reading(reading::shear_force)),
          seaward ? read.peak_shear_seaward : read.peak_shear};
}

ShearError difference(const ShearHistory& answer, const ShearHistory& better) {
  const double largest = better.force.size() > 0 ? better.force.cwiseAbs().maxCoeff() : 0.;
  double most = 0.;
  for (std::size_t i = 0; i < answer.time.size(); ++i)
    most = std::max(most, std::abs(answer.force[static_cast<Eigen::Index>(i)] - value_at(better, answer.time[i])));
  return {over(std::abs(answer.peak - better.peak), std::abs(better.peak)), over(most, largest)};
}

}  // namespace upbead
