// All unknowns of a reduced scene, where its readings are not enough: for fields, and for the stresses of all cells.
#pragma once

#include <functional>
#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/dynamics/reduced_system.h"

namespace upbead {

/// x = V q: the bases of both kinds of unknowns, and a model of the coordinates q.
struct StateModel {
  FieldBasis displacements, phi;
  ModalModel model;  ///< readings: q, then q', then q'' of all coordinates; q'' of phi is 0
};

/// Coordinates at some times, one column each.
struct CoordinateSeries {
  std::vector<double> time;                          ///< s
  Eigen::MatrixXd position, velocity, acceleration;  ///< q, q', q'' (0 of phi), R x times
};

/// respond() of modal_response.h for the model of a StateModel.
CoordinateSeries respond_in_coordinates(const ModalModel& model, const SampledLoads& loads);

/// Calls `see` with the state at each time of the series whose index is in `times`, and that index; x'' of phi is left
/// 0.
void for_each_state(const StateModel& model, const CoordinateSeries& series, const std::vector<Eigen::Index>& times,
                    const std::function<void(const State&, Eigen::Index)>& see);

/// Largest distance of two responses over time, divided by the largest norm of `fine`. The norm is the root of the
/// energy (q'^T M q' + q^T K q)/2. The coordinates of `coarse` are the first ones of `fine`, which belong to `system`.
double energy_distance(const ReducedSystem& system, const CoordinateSeries& fine, const CoordinateSeries& coarse);

}  // namespace upbead
