// Drainage boundary layers: soil that drains into the ground or water beside it within a skin thinner than its cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/caisson/caisson.h"

namespace upbead {

/// A face through which pore water leaves its soil for ground ten times as permeable, or for free water; the pressure
/// is continuous across the face.
struct DrainedFace {
  std::string region, into;        ///< the soil, and where it drains
  dealii::Point<dim> first, last;  ///< its ends (m)
  dealii::Point<dim> inside;       ///< middle of the soil's cell (m)
  double cell = 0.;                ///< h, of the soil's cell across the face (m)
  double consolidation = 0.;       ///< c_v = (1/b)/(1/(lambda + 2 G) + 1/Q), alpha = 1 (m2/s)
};

/// All drained faces of a mesh, without open sides, whose pressure is imposed weakly (fem/sides.h). `scene` as
/// solved.
std::vector<DrainedFace> drained_faces(const Scene& scene, const Mesh& mesh);

/// The shortest time (s) in which the pressure may change without oscillating from cell to cell: h^2/(6 c_v) with
/// pressures of degree 1 [Vermeer and Verruijt 1981, theta = 1], h^2/(40 c_v) with degree 2.
double smallest_time(const DrainedFace& face, int degree_of_pressure);

/// By how much the pressure beside the face overshoots that of undrained soil, relative to it, after a change within
/// `time`; measured on columns of sand below rubble, 20 cells, SDIRK4: docs/warnings.md.
double overshoot(const DrainedFace& face, int degree_of_pressure, double time);

/// A soil under the caisson that drains into ground ten times as permeable. The pressure is continuous, so a pressure
/// of degree q must fall to that of the other ground within the first cell, h, even where the true skin sqrt(c_v t)
/// is far thinner: a part h/(q + 1) of the soil is drained and is compressed by that over lambda + 2 G. (1/(q + 1),
/// which is 1/2 or 1/3, is the least mean deviation from 1 of a polynomial of degree q that must be 0 at one end.)
struct DrainedLayer {
  std::string region, into;
  double cell = 0.;         ///< h, across the face, the mean under the caisson (m)
  double stiffness = 0.;    ///< lambda + 2 G of the soil (Pa)
  double skin = 0.;         ///< sqrt(c_v t) (m)
  double compliance = 0.;   ///< the false part, under a vertical stress (m/Pa)
  double of_the_rest = 0.;  ///< true one of all ground to the depth of a caisson's width (m/Pa)
  double share() const { return compliance / (compliance + of_the_rest); }
};

/// The drained layer with the largest share, under loads that change within `time` (s). The true compliance of the
/// ground, in layers of thickness H under a caisson B wide: H/(lambda + 2 G) of a layer without pores or one that
/// drains, else that of a layer that keeps its volume between rough faces, H/(4 G (1 + (B/2H)^2)) [Gent and Lindley
/// 1959, plane strain], plus the true skin over lambda + 2 G. None without such a soil. `scene` as solved, from which
/// `space` was made.
std::optional<DrainedLayer> drained_layer(const Scene& scene, const Space& space, const Caisson& caisson, double time);

}  // namespace upbead
