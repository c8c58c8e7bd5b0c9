// The computed pore pressure of the ground at any time, on a grid of points.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "upbead/run/simulation.h"

namespace upbead {

/// A rectangle of points side by side.
struct PointGrid {
  std::array<double, 2> x{}, y{};  ///< from, to (m)
  std::array<int, 2> n{2, 2};      ///< points along x and y
  double spacing(int direction) const {
    const auto& ends = direction == 0 ? x : y;
    return (ends[1] - ends[0]) / (n[static_cast<std::size_t>(direction)] - 1);
  }
};

/// Excess pore pressure (Pa) at points, per velocity of each coordinate of the basis, a row for each point; zeros where
/// a point is not in pore water.
Eigen::MatrixXd pressure_readings(const Simulation& simulation, const FieldBasis& basis,
                                  const std::vector<std::array<double, 2>>& points);

/// Excess pore pressure under the loads of a scene, by its PressureModel, which must outlive this.
class PressureMap {
 public:
  PressureMap(const Simulation& simulation, const PressureModel& model, const PointGrid& grid);

  /// Excess pressure (Pa) at (x, y) at the computed time next to `time`, linear between the points of the grid that are
  /// in pore water; 0 where none is near.
  std::function<double(double x, double y)> at(double time) const;
  /// The same at all degrees of freedom of the simulation's space; 0 where these are none of phi.
  Vector at_nodes(double time) const;

 private:
  Vector velocities_at(double time) const;

  PointGrid grid_;
  std::vector<int> row_;  ///< of each point in `rows_`, x fastest; -1: not in pore water
  SparseMatrix rows_;     ///< maps phi' to the pressures of these points
  std::vector<double> time_;
  Eigen::MatrixXd velocities_;  ///< of the coordinates of phi, by coordinate and time
  const FieldBasis* basis_ = nullptr;
  const Unknowns* unknowns_ = nullptr;
};

}  // namespace upbead
