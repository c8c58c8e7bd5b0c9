#include "case/strain_model.h"

#include <algorithm>
#include <cmath>

#include "fem/caisson/reading_names.h"

namespace upbead {

bool follows_strain(const ReducedModelFile& model) {
  return model.case_text.find(".strain]\n") != std::string::npos;
}

std::array<double, 2> forces_of_case(const ReducedModelFile& model) {
  const Eigen::RowVectorXd force = model.modes.feedthrough.row(model.modes.index(reading::force));
  std::array<double, 2> found{0., 0.};
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    const double own = std::abs(force[static_cast<Eigen::Index>(k)]) * model.loads[k].peak;
    found[0] = std::max(found[0], own);
    found[1] += own;
  }
  return found;
}

}  // namespace upbead
