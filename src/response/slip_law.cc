#include "response/slip_law.h"

#include "fem/caisson/reading_names.h"

namespace upbead {

SlipLaw slip_law(const ReducedSystem& system, double friction, UpliftKind uplift,
                 const std::vector<std::string>& outputs) {
  SlipLaw law{friction, {{index_of(system.reading_label, reading::normal_force), 1.}}, {}};
  if (uplift == UpliftKind::computed)
    law.normal_force.emplace_back(index_of(system.reading_label, reading::uplift), -1.);
  for (const std::string& name : outputs) law.readings.push_back(index_of(system.reading_label, name));
  return law;
}

SampledLoads with_load(SampledLoads loads, const Eigen::RowVectorXd& values) {
  const Eigen::Index K = loads.begin.rows(), N = loads.begin.cols();
  for (Eigen::MatrixXd* part : {&loads.begin, &loads.end}) part->conservativeResize(K + 1, Eigen::NoChange);
  loads.begin.row(K) = values.head(N);
  loads.end.row(K) = values.tail(N);
  return loads;
}

bool pushes_seaward_alone(double largest, double least) {
  constexpr double noise = 0.05;
  return least < 0. && largest <= -noise * least;
}

}  // namespace upbead
