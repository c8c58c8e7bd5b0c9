// Where soil drains into what is next to it within a skin thinner than its cells.
#pragma once

#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// A face through which pore water leaves its soil for one ten times as permeable, or for free water, whose pressure
/// is continuous across it.
struct DrainedFace {
  std::string region, into;        ///< the soil, and where it drains
  dealii::Point<dim> first, last;  ///< its ends (m)
  dealii::Point<dim> inside;       ///< middle of the soil's cell (m)
  double cell = 0.;                ///< h, of the soil's cell across the face (m)
  double consolidation = 0.;       ///< c_v = (1/b)/(1/(lambda + 2 G) + 1/Q), alpha = 1 (m2/s)
};

/// All of a mesh; open sides are none, as their pressure is imposed weakly (fem/open_sides.h). `scene` as solved.
std::vector<DrainedFace> drained_faces(const Scene& scene, const Mesh& mesh);

/// The shortest time (s) in which the pressure may change without oscillating from cell to cell: h^2/(6 c_v) with
/// pressures of degree 1 [Vermeer and Verruijt 1981, theta = 1], h^2/(40 c_v) with degree 2.
double smallest_time(const DrainedFace& face, int degree_of_pressure);

/// How far the pressure beside the face overshoots, over that of the undrained soil, after a change within `time`;
/// measured on columns of sand below rubble, 20 cells, SDIRK4: docs/warnings.md.
double overshoot(const DrainedFace& face, int degree_of_pressure, double time);

}  // namespace upbead
