#include "findings/pressure_map.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/compile.h"
#include "fem/probes.h"
#include "fem/space.h"
#include "fem/unknowns.h"
#include "response/reduction.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead {

namespace {

using namespace dealii;

std::array<int, 2> covered(const PointGrid& grid, int direction, double low, double high) {
  const auto d = static_cast<std::size_t>(direction);
  const double first = direction == 0 ? grid.x[0] : grid.y[0], step = grid.spacing(direction);
  return {std::max(0, static_cast<int>(std::ceil((low - first) / step - 1e-9))),
          std::min(grid.n[d] - 1, static_cast<int>(std::floor((high - first) / step + 1e-9)))};
}

/// Calls see(point of the grid, its place in the unit cell) for all points in a cell.
template <class See>
void for_points_in(const Cell& cell, const Mapping<dim>& mapping, const PointGrid& grid, const See& see) {
  const BoundingBox<dim> box = cell->bounding_box();
  const auto [left, right] = covered(grid, 0, box.lower_bound(0), box.upper_bound(0));
  const auto [bottom, top] = covered(grid, 1, box.lower_bound(1), box.upper_bound(1));
  for (int j = bottom; j <= top; ++j)
    for (int i = left; i <= right; ++i) {
      const Point<dim> at(grid.x[0] + i * grid.spacing(0), grid.y[0] + j * grid.spacing(1));
      if (!cell->point_inside(at)) continue;  // of points outside a skew cell the mapping has no inverse
      see(j * grid.n[0] + i, mapping.transform_real_to_unit_cell(cell, at));
    }
}

std::map<int, int> columns_of(const FieldBasis& basis) {
  std::map<int, int> column;
  for (std::size_t i = 0; i < basis.unknown.size(); ++i) column[basis.unknown[i]] = static_cast<int>(i);
  return column;
}

/// Excess pressure at a place in a cell, per velocity of each of the basis' unknowns.
std::vector<std::pair<int, double>> pressure_in(const Simulation& simulation, const Cell& cell, const Point<dim>& unit,
                                                const std::map<int, int>& column) {
  std::vector<std::pair<int, double>> list;
  for (const auto& [unknown, weight] : pressure_row(*simulation.unknowns(), cell, unit))
    if (const auto at = column.find(unknown); at != column.end()) list.emplace_back(at->second, weight);
  return list;
}

}  // namespace

Eigen::MatrixXd pressure_readings(const Simulation& simulation, const FieldBasis& basis,
                                  const std::vector<std::array<double, 2>>& points) {
  const Space& space = *simulation.space();
  const std::map<int, int> column = columns_of(basis);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<bool> found(points.size(), false);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    const BoundingBox<dim> box = cell->bounding_box();
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Point<dim> at(points[p][0], points[p][1]);
      if (found[p] || !box.point_inside(at, 1e-9) || !cell->point_inside(at)) continue;
      found[p] = true;
      for (const auto& [i, weight] :
           pressure_in(simulation, cell, space.mapping().transform_real_to_unit_cell(cell, at), column))
        entries.emplace_back(static_cast<int>(p), i, weight);
    }
  }
  SparseMatrix rows(static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(basis.unknown.size()));
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows * (basis.unit.asDiagonal() * basis.columns());
}

PressureMap::PressureMap(const Simulation& simulation, const PressureModel& model, const PointGrid& grid)
    : grid_(grid) {
  const Space& space = *simulation.space();
  const std::map<int, int> column = columns_of(model.basis);
  row_.assign(static_cast<std::size_t>(grid.n[0]) * static_cast<std::size_t>(grid.n[1]), -1);
  std::vector<Eigen::Triplet<double>> entries;
  int n_rows = 0;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    for_points_in(cell, space.mapping(), grid, [&](int point, const Point<dim>& unit) {
      int& row = row_[static_cast<std::size_t>(point)];
      if (row >= 0) return;
      row = n_rows++;
      for (const auto& [at, weight] : pressure_in(simulation, cell, unit, column))
        entries.emplace_back(row, at, weight);
    });
  }
  rows_.resize(n_rows, static_cast<Eigen::Index>(model.basis.unknown.size()));
  rows_.setFromTriplets(entries.begin(), entries.end());
  const Series series = upbead::respond(model.model, sampled_loads(simulation.scene(), simulation.system()));
  time_ = series.time;
  velocities_ = series.reading;
  basis_ = &model.basis;
  unknowns_ = simulation.unknowns().get();
}

Vector PressureMap::velocities_at(double time) const {
  const auto after = std::lower_bound(time_.begin(), time_.end(), time);
  auto column = static_cast<Eigen::Index>(after - time_.begin());
  if (after == time_.end() || (column > 0 && time - *std::prev(after) < *after - time)) --column;
  return phi_velocities(*basis_, velocities_.col(column));
}

Vector PressureMap::at_nodes(double time) const {
  const Vector phi = velocities_at(time);
  Vector v = Vector::Zero(unknowns_->size());
  for (std::size_t i = 0; i < basis_->unknown.size(); ++i) v[basis_->unknown[i]] = phi[static_cast<Eigen::Index>(i)];
  return unknowns_->expand(v);
}

std::function<double(double, double)> PressureMap::at(double time) const {
  const Eigen::VectorXd pressure = rows_ * velocities_at(time);
  std::vector<double> values(row_.size(), NAN);
  for (std::size_t i = 0; i < row_.size(); ++i)
    if (row_[i] >= 0) values[i] = pressure[row_[i]];
  return [grid = grid_, values = std::move(values)](double x, double y) {
    const double s = std::clamp((x - grid.x[0]) / grid.spacing(0), 0., grid.n[0] - 1.001);
    const double t = std::clamp((y - grid.y[0]) / grid.spacing(1), 0., grid.n[1] - 1.001);
    const int i = static_cast<int>(s), j = static_cast<int>(t);
    double sum = 0., weights = 0.;
    for (const int right : {0, 1})
      for (const int up : {0, 1}) {
        const double value = values[static_cast<std::size_t>((j + up) * grid.n[0] + i + right)];
        const double weight = 1e-9 + (right ? s - i : 1. - s + i) * (up ? t - j : 1. - t + j);
        if (std::isnan(value)) continue;
        sum += weight * value;
        weights += weight;
      }
    return weights > 0. ? sum / weights : 0.;
  };
}

}  // namespace upbead
