// A rigid strip |x| < 1 bonded to an elastic layer on a rigid base or to a half-plane, as scenes of the program, in the
// units of the tables: shear modulus, density and half the strip's width are 1.
//
// The program has no absorbing sides, so waves die in rings of cells around the soil in which the damping ratio d at
// the frequency a0 grows slowly. Rayleigh damping multiplies the stiffness by (1 + i d) and the mass by (1 - i d):
// wave numbers become complex, k (1 - i d), but the impedance stays real, sqrt(1 + d^2), and so little is reflected.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "scenes.h"
#include "strip_theory.h"

namespace upbead::test {

/// Cells: small at the strip's edges, growing outwards and downwards; beyond `calm` the rings, one cell wide each.
struct StiffnessCells {
  double edge = 0.005;      ///< width and height at the strip's edges
  double growth = 3.;       ///< of one cell over its neighbour
  double largest = 1e9;     ///< cell beside the strip, and under it on a half-plane
  double calm = 0.;         ///< width and depth of the undamped soil beside the strip
  double rings = 0.;        ///< width of all rings
  double ring_growth = 1.;  ///< of one ring over its neighbour
  double damping = 0.;      ///< ratio d in the outermost ring; towards it d grows with the cube of the distance
  double largest_below() const { return std::min(largest, 0.6); }  ///< cell of the strip and of a layer's depth
};

/// Rows of cells on the soil under one name, bottom to top.
struct Storey {
  std::string name;
  std::vector<double> heights;  ///< of its lines; the first line is above the storey below
};

/// The mesh of the soil ("soil", "ring0", "ring1", ...), with `storeys` on the strip.
std::unique_ptr<Mesh> stiffness_mesh(const ElasticSoil& soil, const StiffnessCells& cells,
                                     const std::vector<Storey>& storeys);

/// Soil and rings at the frequency a0 on that mesh, fixed at the base and at the far sides; storeys named "strip" are
/// a rigid body without mass, whose coordinates refer to the middle of the strip. Degree 3.
Scene stiffness_scene(const ElasticSoil& soil, const StiffnessCells& cells, const Mesh& mesh, double a0);

/// Cells for waves of the frequency a0. Half-plane: rings over 4 wavelengths of shear. Layer: over 40, as near a
/// cut-off frequency a mode is long and slow, and is reflected if the damping does not grow slowly.
StiffnessCells cells_for(const ElasticSoil& soil, double a0);

/// The inverse of the strip's motions under unit forces and a unit moment.
Stiffness computed_stiffness(const Compiled& compiled, double a0);
Stiffness computed_stiffness(const ElasticSoil& soil, const StiffnessCells& cells, double a0);

}  // namespace upbead::test
