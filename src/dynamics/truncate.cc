#include "dynamics/truncate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace upbead {

TruncatedModel truncated(const ModalModel& model, int n) {
  if (model.n_loads() != 1 || model.n_readings() != 1)
    throw std::invalid_argument("modes are left out of one reading's answer to one load");
  const Eigen::VectorXcd part = model.reading.row(0).transpose().cwiseProduct(model.load.col(0));
  std::vector<double> size;
  for (Eigen::Index m = 0; m < part.size(); ++m)
    size.push_back(model.pole[m] == 0. ? std::numeric_limits<double>::infinity()
                                       : std::abs(part[m] / model.pole[m] / model.pole[m]));
  std::vector<Eigen::Index> order(size.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&size](Eigen::Index m) { return size[static_cast<std::size_t>(m)]; };
  std::stable_sort(order.begin(), order.end(), [&at](Eigen::Index a, Eigen::Index b) { return at(a) > at(b); });

  TruncatedModel out{model, 0.};
  std::vector<Eigen::Index> kept;
  for (const Eigen::Index m : order)
    if (static_cast<int>(kept.size()) < n || std::isinf(at(m))) {
      kept.push_back(m);
    } else {
      out.left_out += at(m);
      out.model.feedthrough(0, 0) -= (part[m] / model.pole[m]).real();
    }
  out.model.pole = model.pole(kept);
  out.model.load = model.load(kept, Eigen::all);
  out.model.reading = model.reading(Eigen::all, kept);
  return out;
}

double truncation_error(const TruncatedModel& truncated, const Eigen::Ref<const Eigen::RowVectorXd>& load,
                        double step) {
  const Eigen::Index n = load.size();
  if (n < 2) return 0.;
  const auto rise = load.tail(n - 1) - load.head(n - 1);
  const double jumps = std::abs(rise[0]) + (rise.tail(n - 2) - rise.head(n - 2)).cwiseAbs().sum();
  return 2. * truncated.left_out * jumps / step;
}

}  // namespace upbead
