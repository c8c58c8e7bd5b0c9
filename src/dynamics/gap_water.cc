#include "dynamics/gap_water.h"

#include <algorithm>

namespace upbead::detail {

namespace {

/// Nodes that are open without a closed one between them and the edge.
template <class Iterator>
std::size_t count_open(Iterator first, Iterator last) {
  return static_cast<std::size_t>(
      std::find_if(first, last, [](ContactState state) { return state != ContactState::open; }) - first);
}

}  // namespace

void GapForces::open(const std::vector<ContactState>& status) {
  share_.clear();
  if (!interface_.gap) return;
  const std::size_t n = status.size();
  std::size_t from = count_open(status.begin(), status.end()), to = n - count_open(status.rbegin(), status.rend());
  is_open_ = {from > 0, to < n};
  if (from == 0 && to == n) return;
  if (from == n) {
    from = 0;
    to = n;
  }
  const std::vector<double>& x = interface_.position;
  // a gap ends halfway between its last node and the next one
  const double begin = from > 0 ? 0.5 * (x[from - 1] + x[from]) : x.front(),
               end = to < n ? 0.5 * (x[to - 1] + x[to]) : x.back();
  for (const double at : x) share_.push_back(end > begin ? std::clamp((end - at) / (end - begin), 0., 1.) : 0.5);
}

Vector GapForces::at(double time, double inside) const {
  const GapWater& water = *interface_.gap;
  const auto n = static_cast<Eigen::Index>(share_.size());
  const Eigen::Map<const Vector> length(interface_.length.data(), n), share(share_.data(), n);
  Vector closed = Vector::Zero(n);
  for (const GapWater::Closed& load : water.closed) closed += load.pressure(time, inside) * load.node;
  std::array<double, 2> end{closed[0] / length[0], closed[n - 1] / length[n - 1]};
  for (std::size_t side = 0; side < 2; ++side)
    if (is_open_[side]) end[side] = std::max(end[side], water.foot[side](time, inside));
  const Vector pressure = (end[1] + (end[0] - end[1]) * share.array()).matrix();
  return length.cwiseProduct(pressure) - closed;
}

}  // namespace upbead::detail
