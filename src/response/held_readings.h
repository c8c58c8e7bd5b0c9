// What one model of all soils has right: F_T, how far the caisson moves, and where the forces on its base act.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "upbead/dynamics/modal_model.h"
#include "upbead/system/system.h"

namespace upbead {

/// Sums of a scene's readings: a row of `sums` and a label each; the first is F_T.
struct HeldReadings {
  Eigen::MatrixXd sums;
  std::vector<ReadingLabel> labels;
};

/// F_T, the displacement of the caisson's centre of gravity, and the moments of the change of the effective forces on
/// the base about its edges,
///
///     M_heel = B/2 (N - U) - (M + M_U),   M_toe = B/2 (N - U) + (M + M_U)   (N m/m)
///
/// N, M: normal force and base moment, U, M_U: uplift and its moment, all of the readings; B: `width` (m). With that of
/// the weight added, M_heel / N' is the distance of the resultant from the heel, on which pressures, margins against
/// overturning and lift depend. Throws std::out_of_range where the scene lacks one of these readings.
HeldReadings held_readings(const std::vector<ReadingLabel>& of_scene, double width);

/// A scene with loads beside its own, which stand for the pressure of the water on the base: U and M_U. Without their
/// responses in a basis the distance of the resultant from an edge is wrong, though F_T is right: docs/soils.md.
constexpr int n_readings_as_loads = 2;
System with_readings_as_loads(System scene);

}  // namespace upbead
