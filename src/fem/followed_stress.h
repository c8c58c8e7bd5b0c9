// Stresses of soil that yields, at points where they are read.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "fem/probes.h"
#include "fem/yielding_soil.h"

namespace upbead {

/// The stress at such a point is that of the soil at the points of quadrature of its cell, each of which follows the
/// strain there from its own state at rest; between them, and from them to the cell's edge, by polynomials. A strain of
/// the cell's degree and an elastic law give the elastic stress at the point itself, exactly. These stresses take no
/// part in any force.
class FollowedStress {
 public:
  /// `readings`: the system's readings, among them those of `points_read`. The system has the first `n_unknowns`
  /// unknowns only.
  FollowedStress(const Space& space, const Unknowns& unknowns, int n_unknowns, const std::vector<Reading>& readings,
                 const PointsOfCells& points, const std::vector<FollowedReading>& points_read);
  /// Commits x. Adds to each reading of these points the stress of the law less the elastic stress, which its rows
  /// give.
  void commit(const Vector& x, Vector& added);
  /// As in SoilAt.
  void remember(std::vector<double>& memory) const;
  const double* recall(const double* memory);

 private:
  struct FollowedPoint {
    std::unique_ptr<SoilPoint> soil;
    double share = 0.;                  ///< of its stress in that of the reading's point
    std::map<int, PlaneStrain> strain;  ///< by unknown
  };
  struct Follower {
    std::vector<FollowedPoint> points;
    std::vector<std::pair<Eigen::Index, double PlaneStress::*>> readings;  ///< by number, with the component of each
  };
  std::vector<Follower> followers_;
};

}  // namespace upbead
