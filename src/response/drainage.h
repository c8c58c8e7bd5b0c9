// Drainage boundary layers: where soil drains into what is next to it within a skin thinner than its cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/caisson/caisson.h"

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

/// All of a mesh; open sides are none, as their pressure is imposed weakly (fem/sides.h). `scene` as solved.
std::vector<DrainedFace> drained_faces(const Scene& scene, const Mesh& mesh);

/// The shortest time (s) in which the pressure may change without oscillating from cell to cell: h^2/(6 c_v) with
/// pressures of degree 1 [Vermeer and Verruijt 1981, theta = 1], h^2/(40 c_v) with degree 2.
double smallest_time(const DrainedFace& face, int degree_of_pressure);

/// How far the pressure beside the face overshoots, over that of the undrained soil, after a change within `time`;
/// measured on columns of sand below rubble, 20 cells, SDIRK4: docs/warnings.md.
double overshoot(const DrainedFace& face, int degree_of_pressure, double time);

/// A soil under the caisson that drains into one ten times as permeable. The pressure is continuous, so that of degree
/// q it must fall to that of the other within the first cell, h, even where the true skin sqrt(c_v t) is far thinner:
/// a part h/(q + 1) of the soil is drained (the least mean of what a polynomial of degree q is away from 1 where it
/// must be 0 at one end: 1/2, 1/3) and yields by that over lambda + 2 G.
struct DrainedLayer {
  std::string region, into;
  double cell = 0.;         ///< h, across the face, the mean under the caisson (m)
  double stiffness = 0.;    ///< lambda + 2 G of the soil (Pa)
  double skin = 0.;         ///< sqrt(c_v t) (m)
  double compliance = 0.;   ///< that is wrong, under a vertical stress (m/Pa)
  double of_the_rest = 0.;  ///< of all ground to the depth of a caisson's width as it should be (m/Pa)
  double share() const { return compliance / (compliance + of_the_rest); }
};

/// The one with the largest share, in loads that change within `time` (s). The rest: layers of thickness H, the caisson
/// B wide, yield by H/(lambda + 2 G) where they have no pores or drain, else as a layer that keeps its volume between
/// rough faces, H/(4 G (1 + (B/2H)^2)) [Gent and Lindley 1959, plane strain], and the true skin over lambda + 2 G. None
/// without such a soil. `scene` as solved, of which the space is.
std::optional<DrainedLayer> drained_layer(const Scene& scene, const Space& space, const Caisson& caisson, double time);

}  // namespace upbead
