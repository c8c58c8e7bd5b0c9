// A rigid caisson bonded to the surface of a layered ground on rock, pushed by a horizontal pulse.
//
// The motion is antisymmetric about the plane through the caisson's middle: there u_y = 0 and p = 0, and the caisson
// does not heave. So one half of ground, caisson and load is computed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scenes.h"

namespace upbead::test {

/// The whole caisson, per metre; the middle of its base is the origin.
struct StripCaisson {
  double half_base;          ///< b (m)
  double mass;               ///< kg/m
  double moment_of_inertia;  ///< about the centre of gravity (kg m2/m)
  double centre;             ///< height of the centre of gravity above the base (m)
  double attack;             ///< height of the load above the base (m)
};

/// A layer of the ground, from the top downwards.
struct Layer {
  std::string name;
  double thickness;  ///< m
  double tallest;    ///< largest height of its cells (m)
  Region soil;
};

/// Cells of the ground: small at the caisson's edge and at the top of every layer, growing in the caisson's
/// surroundings to the size that waves allow, and further towards the far end, which absorbs: pressure waves in
/// saturated soil return from it within a quarter of a second, and with a fixed end F_T was wrong by 1 %.
struct StripCells {
  double edge;     ///< width and height of the cells at the caisson's edge (m)
  double skin;     ///< height of the cells at the top of the lower layers (m)
  double growth;   ///< of one cell over its neighbour
  double along;    ///< largest width of a cell under the caisson and in its surroundings (m)
  double near;     ///< width of the surroundings (m)
  double far;      ///< largest width of a cell beyond (m)
  double width;    ///< of the ground beside the caisson (m)
  int degree = 3;  ///< of u
};

/// The quantities of the reference tables, for a load of peak 1 N/m.
struct StripHistory {
  std::vector<double> time;
  Eigen::RowVectorXd shear;            ///< F_T / P
  Eigen::RowVectorXd sway;             ///< of the middle of the base (m per N/m)
  Eigen::RowVectorXd rotation;         ///< rad per N/m
  Eigen::RowVectorXd moment;           ///< about the middle of the base, over P (m)
  Eigen::RowVectorXd pressure_moment;  ///< integral of p x over the base, over P (m); zero where there is no water
  double peak_shear;                   ///< largest F_T / P, found inside the steps
};

/// One half of the caisson and the ground, and its response to a load that grows linearly. A triangular pulse is a
/// sum of three such ramps; if they begin at ends of steps, the marched response is the same sum, to round-off.
class StripModel {
 public:
  StripModel(const StripCaisson& caisson, const std::vector<Layer>& layers, const Fluid& fluid,
             const StripCells& cells);

  /// Marches from rest to `end` by equal steps, both in s.
  void march_ramp(double end, double step);
  /// The response to a symmetric triangle of that duration (s), an even number of steps.
  StripHistory under_triangle(double duration);
  int n_unknowns() const { return compiled_.system.size(); }

 private:
  Response triangle_response(double duration) const;

  StripCaisson caisson_;
  std::unique_ptr<Mesh> mesh_;
  Compiled compiled_;
  Response ramp_;
};

}  // namespace upbead::test
