#include "contact_demand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"

namespace upbead {

namespace {

/// Rows of shear and normal force come in turns, node by node, as glued() appends them.
void look(const Interface& interface, const Series& series, double margin, GluedDemand& demand) {
  const Eigen::Index n = interface.n_nodes(), columns = static_cast<Eigen::Index>(series.time.size());
  const auto forces = series.reading.bottomRows(2 * n).leftCols(columns);
  const double error = margin * forces.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double rest = interface.normal_force[i];
    for (Eigen::Index t = 0; t < columns; ++t) {
      const double T = std::abs(forces(2 * i, t)), N = rest + forces(2 * i + 1, t);
      demand.slip =
          std::max(demand.slip, N > 0. ? T / (interface.friction * N) : std::numeric_limits<double>::infinity());
      demand.least_normal = std::min(demand.least_normal, N / rest);
      demand.reached = demand.reached || T + error >= interface.friction * (N - error);
    }
  }
}

}  // namespace

GluedDemand contact_demand(const System& system, const Response& response, double margin) {
  GluedDemand demand{0., 1., margin, false};
  look(*system.interface, response.ends, margin, demand);
  look(*system.interface, response.balanced, margin, demand);
  return demand;
}

std::string why_glued(const ContactSummary& contact) {
  const std::string margin =
      contact.demand.margin > 0. ? ", which may err by " + percent(contact.demand.margin) : std::string();
  return "no node pulls or slips: |T| reaches " + percent(contact.demand.slip) + " of mu N, and N falls to " +
         percent(contact.demand.least_normal) + " of that at rest" + margin;
}

}  // namespace upbead
