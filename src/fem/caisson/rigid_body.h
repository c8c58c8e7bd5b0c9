// Rigid bodies: mass, centre of gravity, moment of inertia, and their three motions.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

#include "fem/space.h"

namespace upbead {

/// The motions of a rigid body: landward, upward, and a rotation that is positive when the top moves landward
/// (clockwise; overturning is positive).
enum Motion { motion_x = 0, motion_y = 1, motion_rotation = 2, n_motions = 3 };

/// Displacement at `point` of a unit motion about `centre`: (1, 0), (0, 1), (y - y_c, -(x - x_c)).
dealii::Tensor<1, dim> unit_motion(int motion, const dealii::Point<dim>& point, const dealii::Point<dim>& centre);

/// A body's inertia per metre of breakwater.
struct Body {
  std::string region;
  double area = 0.;               ///< m2
  double mass = 0.;               ///< kg/m
  dealii::Point<dim> centre;      ///< centre of gravity (m)
  double moment_of_inertia = 0.;  ///< about the centre of gravity (kg m2/m)
  dealii::Point<dim> middle{};    ///< of its area (m)
};

/// Area, mass, centre and inertia of one region, from its cells and the values given in the scene; by default of even
/// density but in its parts.
Body make_body(const Space& space, const std::string& region);

/// The bodies of all rigid regions, in the order of the mesh's surfaces.
std::vector<Body> rigid_bodies(const Space& space);

}  // namespace upbead
