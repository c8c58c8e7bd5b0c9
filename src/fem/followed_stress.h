// Stresses of soil that yields where readings tell them.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fem/probes.h"
#include "fem/yielding_soil.h"

namespace upbead {

/// At every such point the law of its cell follows the strain there, from rest on. It takes no part in any force.
class FollowedStress {
 public:
  /// `readings`: those of the system, which `points_read` names; of the unknowns it has the first `n_unknowns`.
  FollowedStress(const Space& space, const Unknowns& unknowns, int n_unknowns, const std::vector<Reading>& readings,
                 const PointsOfCells& points, const std::vector<FollowedReading>& points_read);
  /// x becomes history. To each of these readings is added what the law answers beside the elastic stress of its rows.
  void commit(const Vector& x, Vector& added);
  /// As of SoilPoint.
  void remember(std::vector<double>& memory) const;
  const double* recall(const double* memory);

 private:
  struct Follower {
    std::unique_ptr<SoilPoint> soil;
    ElasticLaw elastic;
    std::vector<std::pair<int, PlaneStrain>> strain;                       ///< by unknown
    std::vector<std::pair<Eigen::Index, double PlaneStress::*>> readings;  ///< and the component of each
  };
  std::vector<Follower> followers_;
};

}  // namespace upbead
