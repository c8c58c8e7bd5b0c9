#include "response/natural_periods.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace upbead {

std::vector<NaturalPeriod> natural_periods(const ModalModel& model, const std::string& name,
                                           const SampledLoads& loads) {
  constexpr double least_share = 0.01;
  const int reading = model.index(name);
  std::vector<Eigen::Index> swinging;
  for (Eigen::Index m = 0; m < model.pole.size(); ++m)
    if (std::abs(model.pole[m].imag()) > -model.pole[m].real()) swinging.push_back(m);  // damping ratio < 1/sqrt(2)
  const auto n = static_cast<Eigen::Index>(swinging.size());
  ModalModel each;
  each.pole = model.pole(swinging);
  each.load = model.load(swinging, Eigen::all);
  each.reading = model.reading(reading, swinging).asDiagonal();
  each.feedthrough = each.impulse = Eigen::MatrixXd::Zero(n, model.n_loads());
  const Eigen::VectorXd largest = respond(each, loads).reading.cwiseAbs().rowwise().maxCoeff();
  std::vector<NaturalPeriod> list;
  for (Eigen::Index i = 0; i < n; ++i)
    if (const double share = largest[i] / largest.sum(); share >= least_share)
      list.push_back({two_pi / std::abs(each.pole[i].imag()), -each.pole[i].real() / std::abs(each.pole[i]), share});
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  return list;
}

}  // namespace upbead
