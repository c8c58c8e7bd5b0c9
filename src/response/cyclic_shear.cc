#include "response/cyclic_shear.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

#include "response/reduction.h"

namespace upbead {

namespace {

std::vector<bool> with_cycles(const Space& space) {
  std::vector<bool> list;
  for (const auto& cell : space.dofs().active_cell_iterators())
    list.push_back(space.region(cell).cyclic.has_value() && space.has_matrices(cell));
  return list;
}

/// Unit vectors over half a circle.
template <std::size_t n>
std::array<std::array<double, 2>, n> directions() {
  std::array<std::array<double, 2>, n> list;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = boost::math::constants::pi<double>() * static_cast<double>(k) / n;
    list[k] = {std::cos(angle), std::sin(angle)};
  }
  return list;
}

/// States at so many times are looked at together, as in monitors.cc.
constexpr std::size_t looked_at_once = 500;

}  // namespace

CyclicShear::CyclicShear(const Space& space, const Unknowns& unknowns)
    : strains_(space, unknowns, with_cycles(space)), n_active_(space.mesh().triangulation.n_active_cells()) {
  for (const auto& cell : strains_.cells()) modulus_.push_back(space.material(cell).G);
  cells_.resize(modulus_.size());
}

void CyclicShear::take(std::size_t cell, const PlaneStrain& strain) {
  const Point now{modulus_[cell] * (strain.xx - strain.yy), 2. * modulus_[cell] * strain.xy};
  static const auto direction = directions<n_directions>();
  for (std::size_t k = 0; k < n_directions; ++k) {
    const auto along = [&d = direction[k]](const Point& p) { return d[0] * p[0] + d[1] * p[1]; };
    Point &far = cells_[cell].points[2 * k], &back = cells_[cell].points[2 * k + 1];
    if (along(now) > along(far)) far = now;
    if (along(now) < along(back)) back = now;
  }
}

void CyclicShear::see(const State& state, int step, int) {
  has_seen_ = true;
  if (step == 0) std::fill(cells_.begin(), cells_.end(), Farthest());
  const std::vector<PlaneStrain> strains = strains_.at(state.x);
  for (std::size_t c = 0; c < cells_.size(); ++c) take(c, strains[c]);
}

void CyclicShear::see(const StateModel& model, const SampledLoads& loads, double duration) {
  has_seen_ = true;
  std::fill(cells_.begin(), cells_.end(), Farthest());
  const CoordinateSeries series = respond_in_coordinates(model.model, loads);
  const std::vector<Eigen::Index> looks = looks_at(series.time, 0.25 * duration);
  for (std::size_t first = 0; first < looks.size(); first += looked_at_once) {
    const std::vector<Eigen::Index> some(
        looks.begin() + static_cast<std::ptrdiff_t>(first),
        looks.begin() + static_cast<std::ptrdiff_t>(std::min(first + looked_at_once, looks.size())));
    const MiddleStrains::Series strains = strains_.at(model.displacements, series.position(Eigen::all, some));
    for (Eigen::Index i = 0; i < strains.xx.cols(); ++i)
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        const auto row = static_cast<Eigen::Index>(c);
        take(c, {strains.xx(row, i), strains.yy(row, i), strains.xy(row, i)});
      }
  }
}

std::vector<double> CyclicShear::amplitude() const {
  std::vector<double> list(n_active_, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    double largest = 0.;
    for (const Point& a : cells_[c].points)
      for (const Point& b : cells_[c].points) largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1]));
    list[strains_.cells()[c]->active_cell_index()] = 0.5 * largest;
  }
  return list;
}

std::vector<double> CyclicShear::memory() const {
  std::vector<double> memory{has_seen_ ? 1. : 0.};
  for (const Farthest& cell : cells_)
    for (const Point& point : cell.points) memory.insert(memory.end(), point.begin(), point.end());
  return memory;
}

void CyclicShear::recall(const std::vector<double>& memory) {
  has_seen_ = memory.at(0) != 0.;
  auto next = memory.begin() + 1;
  for (Farthest& cell : cells_)
    for (Point& point : cell.points)
      for (double& value : point) value = *next++;
}

}  // namespace upbead
