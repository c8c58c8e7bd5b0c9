#include "run/contact/contact_demand.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace upbead {

void look_at_demand(const Interface& interface, const std::vector<UpliftLoad>& uplift, const Series& series,
                    BondedDemand& demand) {
  const Eigen::Index n = interface.n_nodes(), columns = static_cast<Eigen::Index>(series.time.size());
  const auto forces = series.reading.bottomRows(2 * n).leftCols(columns);
  const double error = demand.margin * forces.cwiseAbs().maxCoeff(), mu = interface.friction;
  Eigen::MatrixXd pressure(static_cast<Eigen::Index>(uplift.size()), columns);
  for (Eigen::Index k = 0; k < pressure.rows(); ++k)
    for (Eigen::Index t = 0; t < columns; ++t)
      pressure(k, t) = uplift[static_cast<std::size_t>(k)].pressure(series.time[static_cast<std::size_t>(t)]);
  for (Eigen::Index t = 0; t < columns; ++t)
    for (Eigen::Index i = 0; i < n; ++i) {
      const double rest = interface.normal_force[i], T = std::abs(forces(2 * i, t));
      double N = rest + forces(2 * i + 1, t);
      for (Eigen::Index k = 0; k < pressure.rows(); ++k)
        N -= uplift[static_cast<std::size_t>(k)].node[i] * pressure(k, t);
      demand.slip = std::max(demand.slip, N > 0. ? T / (mu * N) : infinity);
      demand.least_normal = std::min(demand.least_normal, N / rest);
      demand.reached = demand.reached || T + error >= mu * (N - error);
    }
}

BondedDemand contact_demand(const Interface& interface, const std::vector<UpliftLoad>& uplift, const Response& response,
                            double margin) {
  BondedDemand demand{0., 1., margin, false};
  look_at_demand(interface, uplift, response.ends, demand);
  look_at_demand(interface, uplift, response.balanced, demand);
  return demand;
}

}  // namespace upbead
