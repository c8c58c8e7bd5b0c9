// All unknowns of a reduced scene, where its readings do not do: for fields, and for the stresses of all cells.
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
  ModalModel model;  ///< its readings are q, then q', then q'' of all coordinates, 0 of phi
};

/// Coordinates at some times, one column each.
struct CoordinateSeries {
  std::vector<double> time;                          ///< s
  Eigen::MatrixXd position, velocity, acceleration;  ///< q, q', q'' (0 of phi), R x times
};

/// What a model whose readings are those of a StateModel answers, as respond() of modal_response.h.
CoordinateSeries respond_in_coordinates(const ModalModel& model, const SampledLoads& loads);

/// Calls `see` with the state at each of those times, by index; x'' of phi is left 0.
void for_each_state(const StateModel& model, const CoordinateSeries& series, const std::vector<Eigen::Index>& times,
                    const std::function<void(const State&, Eigen::Index)>& see);

/// Largest distance of two answers over time, over the largest of `fine`, as roots of the energy
/// (q'^T M q' + q^T K q)/2 of the difference. The coordinates of `coarse` are the first ones of `fine`, which belong to
/// `system`.
double energy_distance(const ReducedSystem& system, const CoordinateSeries& fine, const CoordinateSeries& coarse);

}  // namespace upbead
