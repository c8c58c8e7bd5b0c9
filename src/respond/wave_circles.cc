#include "respond/wave_circles.h"

#include <algorithm>

namespace upbead {

WaveCircles::WaveCircles(const CircleModel& model, const WaveGrid& grid) : model_(model) {
  if (grid.equal) at_.emplace(model.pressures, *grid.equal);
}

std::optional<CircleInWave> WaveCircles::answer(const WaveSamples& loads, const WaveGrid& grid, bool batch,
                                                const EffectiveBase& base, const Eigen::RowVectorXd& shear) const {
  const std::vector<double> F(shear.begin(), shear.end());
  const auto readings = [&](const std::vector<std::size_t>& moments) -> Eigen::MatrixXd {
    return at_ && batch ? at_->of(loads, moments) : respond_at(model_.pressures, with_jumps(loads, grid), moments);
  };
  const auto found = circle_of_wave(model_.family, base.force, base.moment, F, readings);
  if (!found) return std::nullopt;
  CircleInWave told;
  told.factor = found->factor;
  told.time = grid.time[found->moment];
  told.force = base.force[found->moment];
  told.shear = F[found->moment];
  told.moment = base.moment[found->moment];
  if (found->factor == 0.) return told;
  const FamilyCircle& circle = model_.family.circles[found->circle];
  told.slips = circle.landward ? "landward" : "seaward";
  told.by = found->computed ? "computed" : "still";
  told.centre = {circle.x, circle.y};
  told.radius = circle.radius;
  told.from = circle.from;
  told.to = circle.to;
  return told;
}

std::optional<double> least_sliding_factor(double friction, const EffectiveBase& base, const Eigen::RowVectorXd& shear,
                                           double side) {
  std::optional<double> least;
  for (std::size_t i = 0; i < base.force.size(); ++i) {
    const double F = side * shear[static_cast<Eigen::Index>(i)];
    if (!(F > 1e-6 * friction * base.weight)) continue;
    const double factor = friction * std::max(base.force[i], 0.) / F;
    if (!least || factor < *least) least = factor;
  }
  return least;
}

}  // namespace upbead
